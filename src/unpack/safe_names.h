// Under which names the files of an archive are unpacked.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <unordered_map>

namespace macula::unpack {

// Names in archives are not to be trusted: they lead out of folders, hold control characters, and name
// patients. A part of a path stays as it is if it has at most 100 letters (A to Z), digits, hyphens,
// underscores and points, and does not begin with a point: by such names a DICOMDIR refers to its files. Any
// other part becomes a number, with the extension if that is plain; equal parts in one folder become one
// number, so that the files of a folder stay together.
class SafeNames {
  public:
    struct Place {
        std::filesystem::path path;  // relative, and inside
        bool wasOutside = false;     // the name led out of the folder: absolute, or with ".."
    };
    // Absolute paths begin in the folder; paths with "..", or with more than 32 parts, become a number in it.
    Place placeOf(std::string_view nameInArchive);
    // Another place, for a file whose own is taken.
    std::filesystem::path otherPlace();

    // What macOS adds to archives (AppleDouble, .DS_Store, __MACOSX); dicom::listFiles leaves it out too.
    static bool isLeftByMacOs(std::string_view nameInArchive);

  private:
    std::string numbered(const std::filesystem::path& folder, std::string_view part);

    std::size_t last_ = 0;
    std::unordered_map<std::string, std::string> numbers_;  // of parts, by folder and part
};

}  // namespace macula::unpack
