# The RPMs: the same components, under the names that they have with Debian. rpmbuild (Debian's package rpm) computes what is needed
# of linked libraries. They fit the distribution that they are built on.
find_program(MACULA_RPMBUILD rpmbuild DOC "Makes RPMs: package rpm")
set(CPACK_RPM_COMPONENT_INSTALL ON)
set(CPACK_RPM_FILE_NAME RPM-DEFAULT)
set(CPACK_RPM_PACKAGE_LICENSE Apache-2.0)
set(CPACK_RPM_PACKAGE_RELEASE 1)
set(CPACK_RPM_COMPRESSION_TYPE zstd)
# Stripped already; what else rpmbuild would do to files, such as compiling Python, differs by distribution.
set(CPACK_RPM_SPEC_INSTALL_POST "/bin/true")
# Same bytes for the same SOURCE_DATE_EPOCH.
set(CPACK_RPM_SPEC_MORE_DEFINE "%global use_source_date_epoch_as_buildtime 1
%global clamp_mtime_to_source_date_epoch 1
%global _buildhost macula
%global _build_id_links none")
# Folders that are those of the system.
set(share ${CMAKE_INSTALL_FULL_DATADIR})
set(CPACK_RPM_EXCLUDE_FROM_AUTO_FILELIST_ADDITION
    ${share}/applications ${share}/bash-completion ${share}/bash-completion/completions ${share}/doc ${share}/icons
    ${share}/icons/hicolor ${share}/icons/hicolor/scalable ${share}/icons/hicolor/scalable/apps ${share}/man ${share}/man/man1
    ${share}/metainfo ${CMAKE_INSTALL_PREFIX}/lib ${CMAKE_INSTALL_PREFIX}/lib/python3 ${CMAKE_INSTALL_PREFIX}/lib/python3/dist-packages ${CMAKE_INSTALL_FULL_LIBDIR}
    ${CMAKE_INSTALL_FULL_LIBDIR}/cmake ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig)

# macula_rpm_component(UPPER PACKAGE SUMMARY DESCRIPTION DEPENDS ANY_MACHINE). DEPENDS is as Debian has it; of that stays what Macula's
# packages need of each other, and Python. Others have other names, and are found by what is linked.
macro(macula_rpm_component upper package summary description depends anyMachine)
    set(rpm CPACK_RPM_${upper}_PACKAGE)
    set(${rpm}_NAME ${package})
    set(${rpm}_SUMMARY "${summary}")
    set(${rpm}_DESCRIPTION "${description}")
    string(REGEX MATCHALL "(lib)?macula[a-z0-9-]* \\(= [^)]+\\)|python3" requires "${depends}")
    string(REGEX REPLACE "\\(= ([^)]+)\\)" "= \\1-${CPACK_RPM_PACKAGE_RELEASE}" requires "${requires}")
    string(REPLACE ";" ", " ${rpm}_REQUIRES "${requires}")
    if(${anyMachine})
        set(${rpm}_ARCHITECTURE noarch)
    endif()
endmacro()
