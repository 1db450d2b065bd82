# CPack runs this after each kind of package: CPACK_POST_BUILD_SCRIPTS. Writes what lies beside packages: SHA256SUMS, and the licence
# texts of all that is linked and compiled in.
set(sums ${CPACK_PACKAGE_DIRECTORY}/SHA256SUMS)
set(work ${CPACK_TEMPORARY_DIRECTORY}.again)

# CPack puts files into an archive in the order of the disk, with owners of the machine: once more, in that of their names.
function(macula_pack_archive package)
    execute_process(COMMAND tar --zstd -xf ${package} -C ${work} COMMAND_ERROR_IS_FATAL ANY)
    file(GLOB folder RELATIVE ${work} ${work}/*)
    execute_process(
        COMMAND tar --sort=name --format=gnu --owner=0 --group=0 --numeric-owner --mode=u+rw,go=rX
                --mtime=@$ENV{SOURCE_DATE_EPOCH} -C ${work} -c ${folder}
        COMMAND zstd -q -19 -T1 -f -o ${package}
        COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# To the size of what is installed CPack adds that of folders, which file systems have their own ideas of. As dpkg-gencontrol has it:
# files in whole kibibytes, and one for whatever else there is.
function(macula_pack_debian package)
    execute_process(COMMAND dpkg-deb -R ${package} ${work}/all COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND chmod -R u+rw,go=rX ${work}/all COMMAND_ERROR_IS_FATAL ANY)  # scripts have what the umask left
    file(GLOB_RECURSE entries LIST_DIRECTORIES ON ${work}/all/*)
    list(FILTER entries EXCLUDE REGEX "/all/DEBIAN(/|$)")
    set(kibibytes 0)
    foreach(entry ${entries})
        set(size 1)
        if(NOT IS_DIRECTORY ${entry} AND NOT IS_SYMLINK ${entry})
            file(SIZE ${entry} bytes)
            math(EXPR size "(${bytes} + 1023) / 1024")
        endif()
        math(EXPR kibibytes "${kibibytes} + ${size}")
    endforeach()
    execute_process(COMMAND sed -i "s/^Installed-Size: .*/Installed-Size: ${kibibytes}/" ${work}/all/DEBIAN/control
        COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND find ${work}/all -exec touch -h -d @$ENV{SOURCE_DATE_EPOCH} {} + COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND dpkg-deb --root-owner-group --threads-max=1 -Zxz -b ${work}/all ${package} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endfunction()

foreach(package ${CPACK_PACKAGE_FILES})
    file(REMOVE_RECURSE ${work})
    file(MAKE_DIRECTORY ${work})
    if(package MATCHES "\\.tar\\.zst$")
        macula_pack_archive(${package})
    elseif(package MATCHES "\\.deb$")
        macula_pack_debian(${package})
    endif()
    file(REMOVE_RECURSE ${work})
endforeach()

# Of packages that were made before, the lines stay.
set(lines)
if(EXISTS ${sums})
    file(STRINGS ${sums} lines)
endif()
foreach(package ${CPACK_PACKAGE_FILES})
    cmake_path(GET package FILENAME name)
    list(FILTER lines EXCLUDE REGEX "  ${name}$")
    file(SHA256 ${package} sum)
    list(APPEND lines "${sum}  ${name}")
endforeach()
foreach(line ${lines})
    string(SUBSTRING "${line}" 66 -1 name)
    set(made ${CPACK_PACKAGE_FILES})
    list(FILTER made INCLUDE REGEX "/${name}$")
    if(NOT made AND NOT EXISTS ${CPACK_PACKAGE_DIRECTORY}/${name})
        list(REMOVE_ITEM lines "${line}")
    endif()
endforeach()
list(SORT lines)
list(JOIN lines "\n" lines)
file(WRITE ${sums} "${lines}\n")

file(GLOB bills ${CPACK_MACULA_BILLS}/*.cdx.json)
if(bills)
    execute_process(COMMAND ${CMAKE_CURRENT_LIST_DIR}/sbom licences ${CPACK_PACKAGE_DIRECTORY}/licences ${bills}
        COMMAND_ERROR_IS_FATAL ANY)
endif()
