# CMake joins several sources into one unit: the compiler reads what they include once, and makes templates once
# (docs/measurements/build.md has the times). units.py chooses which, so that no name of one clashes with another's. If the
# compiler reports a redefinition after a change, configure again. `./check` compiles changed sources of `src` alone as well, so
# that none depends on what another includes.
option(MACULA_UNITY "Compile several sources as one unit" ${PROJECT_IS_TOP_LEVEL})

# Not in what is packaged, of which every source is compiled as it would be elsewhere, nor where lines are counted.
if(MACULA_UNITY AND NOT CMAKE_BUILD_TYPE STREQUAL "Release" AND NOT MACULA_COVERAGE)
    find_package(Python3 COMPONENTS Interpreter)
endif()
if(Python3_FOUND)
    set(CMAKE_UNITY_BUILD ON)
    # Of a class in a source, whose members have types of its unnamed namespace: there, it has been included.
    list(APPEND MACULA_WARNINGS $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
    # GCC 12 takes an optional value for uninitialised where it inlines what another source of the unit defines.
    list(APPEND MACULA_WARNINGS $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    # Clang finds that a local constant hides one of another source of the unit.
    list(APPEND MACULA_WARNINGS $<$<CXX_COMPILER_ID:Clang>:-Wno-shadow>)
endif()

# A line `directory;target;file` for each source in C++ of `folder` and below. Examples in C are each a program's. What the build
# makes is compiled by itself: where nothing is built yet, there is no such file to read.
function(macula_list_sources folder list)
    get_property(folders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
    get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
    foreach(target IN LISTS targets)
        get_target_property(sources ${target} SOURCES)
        get_target_property(place ${target} SOURCE_DIR)
        set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
        foreach(source IN LISTS sources)
            cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${place} NORMALIZE OUTPUT_VARIABLE file)
            cmake_path(IS_PREFIX PROJECT_BINARY_DIR ${file} is_made)
            get_source_file_property(is_alone ${file} TARGET_DIRECTORY ${target} SKIP_UNITY_BUILD_INCLUSION)
            if(file MATCHES "\\.cpp$" AND NOT is_made AND NOT is_alone)
                file(APPEND ${list} "${place};${target};${file}\n")
            endif()
        endforeach()
    endforeach()
    foreach(below IN LISTS folders)
        macula_list_sources(${below} ${list})
    endforeach()
endfunction()

# At the end, when every target is known.
function(macula_make_units)
    if(NOT CMAKE_UNITY_BUILD OR NOT Python3_FOUND)
        return()
    endif()
    set(list ${PROJECT_BINARY_DIR}/units.txt)
    set(units ${PROJECT_BINARY_DIR}/units.cmake)
    file(WRITE ${list} "")
    macula_list_sources(${PROJECT_SOURCE_DIR} ${list})
    execute_process(COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/cmake/units.py ${units} INPUT_FILE ${list}
        COMMAND_ERROR_IS_FATAL ANY)
    include(${units})
endfunction()
