# cmake -D OUT=embedded.h -D ROOT=rules -P embed.cmake: the rules as a C++ header.
file(READ ${ROOT}/split.json split)
file(WRITE ${OUT}.part "// Made by src/dicom/rules/embed.cmake.\n#pragma once\n\n#include <string_view>\n\nnamespace macula::dicom::rules {\n\ninline constexpr std::string_view kSplit = R\"rules(${split})rules\";\n\n}  // namespace macula::dicom::rules\n")
file(RENAME ${OUT}.part ${OUT})
