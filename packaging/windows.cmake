# The installer for Windows, by NSIS. It has never been built or run there: docs/packages.md. makensis takes it, with the programs
# of another system in it, by `cpack -G NSIS`.
if(WIN32)
    set(CPACK_GENERATOR NSIS ZIP)
endif()
set(CPACK_NSIS_DISPLAY_NAME Macula)
set(CPACK_NSIS_PACKAGE_NAME Macula)
set(CPACK_NSIS_CONTACT ${CPACK_PACKAGE_CONTACT})
set(CPACK_NSIS_COMPRESSOR "/SOLID lzma")
set(CPACK_NSIS_MANIFEST_DPI_AWARE ON)
set(CPACK_NSIS_MODIFY_PATH ON)
# An older version goes first; what people kept is in their own folders, and stays.
set(CPACK_NSIS_ENABLE_UNINSTALL_BEFORE_INSTALL ON)
set(CPACK_NSIS_INSTALLED_ICON_NAME bin/macula-viewer.exe)
set(CPACK_NSIS_MUI_FINISHPAGE_RUN macula-viewer.exe)
set(CPACK_NSIS_MENU_LINKS "share/doc/macula-doc" "Documentation")
# In the start menu, and offered for DICOM files without taking them from another program.
set(CPACK_PACKAGE_EXECUTABLES macula-viewer Macula)
set(CPACK_NSIS_EXTRA_INSTALL_COMMANDS [=[
    WriteRegStr SHCTX "Software\Classes\Macula.Dicom" "" "DICOM file"
    WriteRegStr SHCTX "Software\Classes\Macula.Dicom\shell\open\command" "" '"$INSTDIR\bin\macula-viewer.exe" "%1"'
    WriteRegStr SHCTX "Software\Classes\.dcm\OpenWithProgids" "Macula.Dicom" ""
    WriteRegStr SHCTX "Software\Classes\MIME\Database\Content Type\application/dicom" "Extension" ".dcm"
]=])
set(CPACK_NSIS_EXTRA_UNINSTALL_COMMANDS [=[
    DeleteRegValue SHCTX "Software\Classes\.dcm\OpenWithProgids" "Macula.Dicom"
    DeleteRegKey SHCTX "Software\Classes\Macula.Dicom"
]=])
