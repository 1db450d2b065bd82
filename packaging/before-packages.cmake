# CPack runs this on the files of packages, before each kind is made: CPACK_PRE_BUILD_SCRIPTS. What the umask, the clock and the
# working tree of a machine left on them is taken off.
if(CMAKE_HOST_WIN32)
    return()
endif()
execute_process(COMMAND chmod -R u+rw,go=rX ${CPACK_TEMPORARY_DIRECTORY} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND find ${CPACK_TEMPORARY_DIRECTORY} -exec touch -h -d @$ENV{SOURCE_DATE_EPOCH} {} +
    COMMAND_ERROR_IS_FATAL ANY)
