# Compiler settings, and the two functions with which every module and test is declared.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

# In another project, its own folders, kinds of builds, launchers and linker are taken, and nothing of it is changed.
if(PROJECT_IS_TOP_LEVEL)
    set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
    if(NOT CMAKE_BUILD_TYPE)
        set(CMAKE_BUILD_TYPE RelWithDebInfo CACHE STRING "" FORCE)
    endif()

    # Line numbers are what a backtrace needs; names of all locals and types cost a quarter of the time of a build. For stepping
    # through: -DCMAKE_BUILD_TYPE=Debug.
    set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O2 -g1 -DNDEBUG")

    find_program(CCACHE ccache)
    if(CCACHE)
        # A clone in another folder, as CI makes one, finds what was compiled here.
        set(launcher ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${CCACHE})
        set(CMAKE_CXX_COMPILER_LAUNCHER ${launcher})
        set(CMAKE_C_COMPILER_LAUNCHER ${launcher})
    endif()

    # lld links in a sixth of the time of the system linker, which is the fallback, and links what is packaged. Debian 12's mold
    # does not end on one of our test programs.
    find_program(LLD ld.lld)
    if(LLD AND NOT CMAKE_BUILD_TYPE STREQUAL "Release")
        add_link_options(-fuse-ld=lld)
    endif()
elseif(NOT CMAKE_RUNTIME_OUTPUT_DIRECTORY)
    set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
endif()

# Warnings are errors where Macula is worked on. What is packaged, and what sanitizers change, is optimised otherwise, of which
# GCC 12 warns without reason (its bugs 105329 and 105651); nobody's build is to stop for another compiler's warnings.
set(MACULA_ERRORS)
if(NOT MACULA_SANITIZE)
    set(MACULA_ERRORS $<$<CONFIG:RelWithDebInfo,Debug>:-Werror>)
endif()
set(MACULA_WARNINGS -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual ${MACULA_ERRORS}
    -Wno-missing-field-initializers)  # designated initialisers leave fields at their defaults on purpose
# Races cannot be looked for together with wrong addresses: the two keep their notes in the same place.
if(MACULA_SANITIZE STREQUAL "thread")
    add_compile_options(-fsanitize=thread -fno-omit-frame-pointer)
    add_link_options(-fsanitize=thread)
elseif(MACULA_SANITIZE)
    add_compile_options(-fsanitize=address,undefined -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
    add_link_options(-fsanitize=address,undefined)
endif()
if(MACULA_SANITIZE)
    add_library(macula_kept_libraries OBJECT ${PROJECT_SOURCE_DIR}/tests/suppressions/kept_libraries.c)
    link_libraries($<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>:$<TARGET_OBJECTS:macula_kept_libraries>>)
    add_link_options(LINKER:--export-dynamic-symbol=dlclose)
endif()
# Which lines the tests run: packaging/coverage. Counters of threads are added up without loss.
if(MACULA_COVERAGE)
    add_compile_options(--coverage -fprofile-update=atomic -O1)
    add_link_options(--coverage)
endif()
# float-cast-overflow is no part of clang's undefined, although it is undefined.
if(MACULA_FUZZ)
    add_compile_options(-fsanitize=fuzzer-no-link,address,undefined,float-cast-overflow -fno-sanitize-recover=all
        -fno-omit-frame-pointer)
    add_link_options(-fsanitize=address,undefined)
endif()

# What is packaged does not tell in which folder it was built, and two builds of it are the same bytes: packaging/compare-builds.
# The last map that fits is taken. With ccache the compiler is called with paths that begin at the folder of the build.
file(RELATIVE_PATH sourceFromBuild ${PROJECT_BINARY_DIR} ${PROJECT_SOURCE_DIR})
if(sourceFromBuild)
    string(REGEX REPLACE "/$" "" sourceFromBuild "${sourceFromBuild}")
    add_compile_options($<$<CONFIG:Release>:-ffile-prefix-map=${sourceFromBuild}/=>)
endif()
add_compile_options($<$<CONFIG:Release>:-ffile-prefix-map=${PROJECT_SOURCE_DIR}/=>
    $<$<CONFIG:Release>:-ffile-prefix-map=${PROJECT_BINARY_DIR}/=build/>)
add_link_options($<$<CONFIG:Release>:LINKER:--build-id=sha1>)

# What is packaged makes it hard to get from a fault in memory to code: cookies in stack frames, stacks that cannot jump over their
# guard page, checked lengths of libc, addresses by chance (PIE), and tables of addresses that are full and read-only before the first
# line runs. Debian's GCC does only the fourth by itself. tests/packaging reads it off what is linked.
include(CheckCXXCompilerFlag)
include(CheckPIESupported)
check_pie_supported(LANGUAGES CXX)
foreach(flag -fstack-protector-strong -fstack-clash-protection -fcf-protection)
    string(MAKE_C_IDENTIFIER "MACULA_HAS${flag}" has)
    check_cxx_compiler_flag(${flag} ${has})
    if(${has})
        add_compile_options($<$<CONFIG:Release>:${flag}>)
    endif()
endforeach()
add_link_options($<$<CONFIG:Release>:LINKER:-z,relro> $<$<CONFIG:Release>:LINKER:-z,now> $<$<CONFIG:Release>:LINKER:-z,noexecstack>)
if(NOT MACULA_SANITIZE AND NOT MACULA_FUZZ)
    add_compile_options($<$<CONFIG:Release>:-U_FORTIFY_SOURCE> $<$<CONFIG:Release>:-D_FORTIFY_SOURCE=3>)
endif()

find_package(Threads REQUIRED)

include(GNUInstallDirs)

# macula_module(NAME SOURCES … PUBLIC … PRIVATE …): the static library macula_NAME, alias macula::NAME. Its symbols are hidden:
# a program or library of somebody else that holds it does not export them. What is installed: packaging/libraries.
function(macula_module name)
    cmake_parse_arguments(M "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
    add_library(macula_${name} STATIC ${M_SOURCES})
    add_library(macula::${name} ALIAS macula_${name})
    set_target_properties(macula_${name} PROPERTIES EXPORT_NAME ${name} CXX_VISIBILITY_PRESET hidden
        VISIBILITY_INLINES_HIDDEN ON)
    target_compile_features(macula_${name} PUBLIC cxx_std_20)
    target_include_directories(macula_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
        $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/macula>)
    target_compile_options(macula_${name} PRIVATE ${MACULA_WARNINGS})
    target_link_libraries(macula_${name} PUBLIC ${M_PUBLIC} PRIVATE ${M_PRIVATE})
endfunction()

# macula_vector_sources(SOURCE …): sources that include themselves once for each instruction set (hwy/foreach_target.h), of a target
# that is linked with macula::vectors. The options change no value.
function(macula_vector_sources)
    set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON
        COMPILE_OPTIONS "-O3;-fno-math-errno;-fno-trapping-math;-Wno-shadow")
endfunction()

# macula_plugin(NAME SOURCES … PRIVATE …): macula-NAME.so, which base/plugin.h loads: beside the programs in the build, and in a
# folder of its own once installed.
set(MACULA_PLUGIN_DIR ${CMAKE_INSTALL_LIBDIR}/macula)  # under the prefix
function(macula_plugin name)
    cmake_parse_arguments(M "" "" "SOURCES;PRIVATE" ${ARGN})
    add_library(macula_plugin_${name} MODULE ${M_SOURCES})
    set_target_properties(macula_plugin_${name} PROPERTIES PREFIX "" OUTPUT_NAME macula-${name}
        LIBRARY_OUTPUT_DIRECTORY ${CMAKE_RUNTIME_OUTPUT_DIRECTORY})
    target_include_directories(macula_plugin_${name} PRIVATE ${PROJECT_SOURCE_DIR}/src)
    target_compile_options(macula_plugin_${name} PRIVATE ${MACULA_WARNINGS})
    target_link_libraries(macula_plugin_${name} PRIVATE ${M_PRIVATE})
endfunction()

# Where time goes into starting, reading and comparing, a second of a compiler is worth more than a millisecond of a run.
# GCC 12 optimises less then, and takes lists of objects for uninitialised.
set(MACULA_QUICK_TO_COMPILE $<$<CONFIG:RelWithDebInfo>:-O1>
    $<$<AND:$<CONFIG:RelWithDebInfo>,$<CXX_COMPILER_ID:GNU>>:-Wno-maybe-uninitialized>)

# Where files of others are read: an index out of range ends the program, and is not used. Lengths of libc are checked in all of a
# release, above.
set(MACULA_HARDENED $<$<CONFIG:RelWithDebInfo,Release>:-D_GLIBCXX_ASSERTIONS>)
if(NOT MACULA_SANITIZE AND NOT MACULA_FUZZ)  # which look closer, and cannot where this does
    list(APPEND MACULA_HARDENED $<$<CONFIG:RelWithDebInfo>:-U_FORTIFY_SOURCE> $<$<CONFIG:RelWithDebInfo>:-D_FORTIFY_SOURCE=2>)
endif()

# macula_test(NAME SOURCES … LIBS … [TIMEOUT seconds] [SHARES thing] [SHADERS filter]): one GoogleTest executable, one ctest entry
# per test; two that share a thing, such as the display, never run at once. They begin first: alone at the end, they would leave
# cores idle.
function(macula_test name)
    cmake_parse_arguments(T "" "TIMEOUT;SHARES;SHADERS" "SOURCES;LIBS" ${ARGN})
    if(NOT T_TIMEOUT)
        set(T_TIMEOUT 600)
    endif()
    if(MACULA_SANITIZE OR MACULA_COVERAGE)  # which take their time
        math(EXPR T_TIMEOUT "${T_TIMEOUT} * 10")
    endif()
    add_executable(test_${name} ${T_SOURCES})
    target_compile_options(test_${name} PRIVATE ${MACULA_WARNINGS} ${MACULA_QUICK_TO_COMPILE})
    target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/tests)
    target_link_libraries(test_${name} PRIVATE ${T_LIBS} test_paths test_own_data_folder GTest::gtest_main)
    set(lock)
    if(T_SHARES)
        set(lock RESOURCE_LOCK ${T_SHARES} COST 1000)
    endif()
    gtest_discover_tests(test_${name} TEST_PREFIX "${name}." DISCOVERY_MODE PRE_TEST
        PROPERTIES TIMEOUT ${T_TIMEOUT} LABELS ${name} ${lock})
    # On a CPU device some kernels run on the host in place of the shaders that a graphics card runs: the tests that SHADERS chooses
    # (as --gtest_filter) also run the shaders.
    if(T_SHADERS)
        gtest_discover_tests(test_${name} TEST_PREFIX "${name}.shaders." DISCOVERY_MODE PRE_TEST TEST_FILTER "${T_SHADERS}"
            PROPERTIES TIMEOUT ${T_TIMEOUT} LABELS ${name} ${lock} ENVIRONMENT "MACULA_NATIVE_KERNELS=off")
    endif()
endfunction()
