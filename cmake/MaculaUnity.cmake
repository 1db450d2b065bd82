# CMake joins several sources into one unit: the compiler reads what they include once, and makes templates once
# (docs/measurements/build.md has the times). The unnamed namespace of one source is then visible to the sources behind it.
# MaculaAlone.cmake lists the sources whose names clash with another's; they are compiled alone. If the compiler reports a
# redefinition in a new source, rename, or list the source there. `./check` compiles changed sources of `src` alone as well,
# so that none depends on what another includes.
option(MACULA_UNITY "Compile several sources as one unit" ${PROJECT_IS_TOP_LEVEL})

# Not in what is packaged, of which every source is compiled as it would be elsewhere, nor where lines are counted.
if(MACULA_UNITY AND NOT CMAKE_BUILD_TYPE STREQUAL "Release" AND NOT MACULA_COVERAGE)
    set(CMAKE_UNITY_BUILD ON)
    set(CMAKE_UNITY_BUILD_BATCH_SIZE 8)
    # Of a class in a source, whose members have types of its unnamed namespace: there, it has been included.
    list(APPEND MACULA_WARNINGS $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
    # Clang finds that a local constant hides one of another source of the unit.
    list(APPEND MACULA_WARNINGS $<$<CXX_COMPILER_ID:Clang>:-Wno-shadow>)
    include(MaculaAlone)
endif()

# At the end, when every target is known: properties of sources are of a folder.
function(macula_compile_alone folder)
    if(NOT MACULA_ALONE)
        return()
    endif()
    get_property(folders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
    get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
    foreach(target IN LISTS targets)
        get_target_property(sources ${target} SOURCES)
        get_target_property(place ${target} SOURCE_DIR)
        foreach(source IN LISTS sources)
            if(source MATCHES "\\.(c|cpp)$")
                cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${place} NORMALIZE OUTPUT_VARIABLE file)
                cmake_path(RELATIVE_PATH file BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE name)
                if(name IN_LIST MACULA_ALONE OR source MATCHES "\\.c$")  # examples in C are each a program's
                    set_source_files_properties(${file} TARGET_DIRECTORY ${target} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
                endif()
            endif()
        endforeach()
    endforeach()
    foreach(below IN LISTS folders)
        macula_compile_alone(${below})
    endforeach()
endfunction()
