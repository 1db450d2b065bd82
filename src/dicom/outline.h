// The shape of a DICOM file, from its element headers alone, without recursion and without DCMTK's parser:
// what has to be known before the file may be handed to that parser.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace macula::dicom {

struct Outline {
    // DCMTK's parser calls itself for every level, and dies on its stack when there are thousands; no real
    // object has more than a dozen.
    bool nestedTooDeep = false;
    // Deflated, and far larger than its image: DCMTK would inflate all of it into memory.
    bool inflatesTooFar = false;
    // Of the pixel data at the top level, when they are not encapsulated: the length that the file claims.
    std::optional<std::uint64_t> nativePixelBytes;
    // The pixel data are whole, and fewer bytes follow them than an element header has.
    bool strayBytesAfterPixels = false;

    bool isSafeToParse() const { return !nestedTooDeep && !inflatesTooFar; }
};

// `hasPreamble`: the 128 bytes and DICM are there. Reads no values but a few of a few bytes. Thread-safe. May
// throw std::bad_alloc.
Outline outlineOf(const std::filesystem::path& file, bool hasPreamble);

}  // namespace macula::dicom
