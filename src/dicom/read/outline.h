// Reads the structure of a DICOM file from its element headers alone, without recursion: the place of the
// pixel data, and a tree of the elements before them.
//
// DCMTK's parser recurses and inflates without bounds, so this walk was first a check that ran before it. As
// it visits every element anyway, it now builds the tree too: that made the parser superfluous, and reads
// headers five times as fast. A test compares each element of all real files with DCMTK.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "dicom/read/byte_source.h"
#include "dicom/read/element_tree.h"

namespace macula::dicom {

// The pixel data at the top level: PixelData, FloatPixelData or DoubleFloatPixelData.
struct PixelDataOutline {
    Tag tag{};
    bool encapsulated = false;
    std::uint64_t offset = 0;     // in the file (when deflated, in the inflated data): of the value, or of
                                  // its first item when encapsulated
    std::uint64_t claimed = 0;    // bytes, unless encapsulated
    std::uint64_t present = 0;    // those of `claimed` that are in the file
    bool whole = false;           // complete, with all fragments
    std::uint64_t fragments = 0;  // encapsulated: after the Basic Offset Table
    // The number of fragments that begin like a stream of JPEG, JPEG-LS, JPEG 2000 or run lengths. Each frame
    // has one such fragment, unless several frames share one.
    std::uint64_t streams = 0;
    bool repeated = false;  // the file has pixel data a second time
};

struct Outline {
    bool nestedTooDeep = false;  // no real object has more than a dozen levels
    // Deflated, and far larger than its image: a megabyte can make a gigabyte.
    bool inflatesTooFar = false;
    // The elements before the pixel data are larger than any real header.
    bool headerTooLarge = false;
    // Everything before the pixel data could be read; without pixel data, up to the end of the file.
    bool headerWhole = false;
    std::optional<PixelDataOutline> pixels;
    // Bytes after whole pixel data that are not elements; in a deflated file 1 when there are any.
    std::uint64_t strayBytes = 0;
    std::uint64_t datasetOffset = 0;  // in the file: where the file meta information ends
    // The UID of the file meta information; without one, that found from the dataset; and where the pixels
    // are streams of another encoding, one of that encoding.
    std::string transferSyntaxUid;
    // That of the file meta information, if the pixels have another encoding.
    std::string contradictedSyntaxUid;

    // Whether the file stays within the bounds of any real object.
    bool isPlausible() const { return !nestedTooDeep && !inflatesTooFar && !headerTooLarge; }
};

// `hasPreamble`: the file has the 128 bytes and DICM. Fills `tree`, unless null, with the elements before the
// pixel data, and the short ones of the file meta information. Thread-safe. May throw std::bad_alloc.
Outline outlineOf(ByteSource& source, bool hasPreamble, ElementTree* tree);
Outline outlineOf(const std::filesystem::path& file, bool hasPreamble);

}  // namespace macula::dicom
