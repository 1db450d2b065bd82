// The text headers of NRRD and MetaImage files.
//
// Does not use the readers of ITK (5.2.1), which silently mirror NRRD images of the space
// left-anterior-superior, accept a damaged compressed MetaImage as complete, and open any file that a header
// names, anywhere. Nor can they be fuzzed here: Debian's ITK does not compile with clang, which libFuzzer
// needs.
#pragma once

#include <filesystem>

#include "formats/raw_values.h"

namespace macula::formats {

struct TextHeader {
    RawImageLayout layout;
    ValuesInFile values;
};

// inputNotUsable for images that are not a volume of scalars, for encodings other than raw and deflate, for
// values in several files or outside the folder of the header, and for a header that contradicts itself or
// the size of the file.
Result<TextHeader> readNrrdHeader(const std::filesystem::path& path);
Result<TextHeader> readMetaImageHeader(const std::filesystem::path& path);

}  // namespace macula::formats
