// The headers of NRRD and MetaImage files, which are text.
//
// Not read by ITK (5.2.1), which does three things in silence here: it mirrors NRRD images of the space
// left-anterior-superior, takes a damaged compressed MetaImage for a whole one, and opens whatever file a
// header names, wherever that lies. Its readers cannot be fuzzed here either: Debian's ITK does not compile
// with clang, which libFuzzer needs.
#pragma once

#include <filesystem>

#include "formats/raw_values.h"

namespace macula::formats {

struct TextHeader {
    RawImageLayout layout;
    ValuesInFile values;
};

// Fail with inputNotUsable: for what is no volume of scalars, for encodings other than raw and deflate, for
// values in several files or outside the folder of the header, and for a header that contradicts itself or
// the size of the file.
Result<TextHeader> readNrrdHeader(const std::filesystem::path& path);
Result<TextHeader> readMetaImageHeader(const std::filesystem::path& path);

}  // namespace macula::formats
