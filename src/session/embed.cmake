# cmake -D OUT=file.cpp -D FOLDER=migrations -P embed.cmake: writes every migration into one C++ file, in order
# of their numbers.
file(GLOB files ${FOLDER}/*.sql)
list(SORT files)
set(rows "")
set(expected 0)
foreach(file ${files})
    get_filename_component(name ${file} NAME_WLE)
    math(EXPR expected "${expected} + 1")
    if(NOT name MATCHES "^([0-9][0-9][0-9][0-9])_[a-z_]+$")
        message(FATAL_ERROR "${file}: a migration is called 0001_what_it_does.sql")
    endif()
    math(EXPR number "1${CMAKE_MATCH_1} - 10000")
    if(NOT number EQUAL expected)
        message(FATAL_ERROR "${file}: number ${expected} is missing or there twice")
    endif()
    file(READ ${file} sql)
    string(APPEND rows "        {${number}, \"${name}\", R\"migration(${sql})migration\"},\n")
endforeach()
file(WRITE ${OUT}.part "// Made by src/session/embed.cmake.\n#include \"session/migrations.h\"\n
namespace macula::session {

std::span<const Migration> migrations() {
    static constexpr Migration all[] = {\n${rows}    };
    return all;
}

}  // namespace macula::session\n")
file(RENAME ${OUT}.part ${OUT})
