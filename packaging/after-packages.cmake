# CPack runs this after each kind of package: CPACK_POST_BUILD_SCRIPTS. Writes what lies beside packages: SHA256SUMS, and the licence
# texts of all that is linked and compiled in.
set(sums ${CPACK_PACKAGE_DIRECTORY}/SHA256SUMS)
set(work ${CPACK_TEMPORARY_DIRECTORY}.again)

# CPack puts files into an archive in the order of the disk, with owners of the machine: once more, in that of their names.
foreach(package ${CPACK_PACKAGE_FILES})
    if(package MATCHES "\\.tar\\.zst$")
        file(REMOVE_RECURSE ${work})
        file(MAKE_DIRECTORY ${work})
        execute_process(COMMAND tar --zstd -xf ${package} -C ${work} COMMAND_ERROR_IS_FATAL ANY)
        execute_process(
            COMMAND tar --sort=name --format=gnu --owner=0 --group=0 --numeric-owner --mode=u+rw,go=rX
                    --mtime=@$ENV{SOURCE_DATE_EPOCH} -C ${work} -c .
            COMMAND zstd -q -19 -T1 -f -o ${package}
            COMMAND_ERROR_IS_FATAL ANY)
        file(REMOVE_RECURSE ${work})
    endif()
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
