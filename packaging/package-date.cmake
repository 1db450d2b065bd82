# CPack reads this before each kind of package: CPACK_PROJECT_CONFIG_FILE. Files are dated by the last commit, so that two builds give
# the same bytes; without git, by a day that is written here.
if("$ENV{SOURCE_DATE_EPOCH}" STREQUAL "")
    execute_process(COMMAND git log -1 --format=%ct WORKING_DIRECTORY ${CMAKE_CURRENT_LIST_DIR} OUTPUT_VARIABLE date
        OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE result)
    if(NOT result STREQUAL 0 OR NOT date MATCHES "^[0-9]+$")
        set(date 1764028800)  # 25 November 2025
    endif()
    set(ENV{SOURCE_DATE_EPOCH} ${date})
endif()
