// The shape of a DICOM file, from its element headers alone and without recursion: where the pixel data are,
// and, in a tree, all that stands before them.
//
// DCMTK's parser recurses and inflates without bounds, so this walk came before it as a check. It visits
// every element; keeping what it sees made the parser superfluous, and headers five times as fast. A test
// compares each element of all real files with DCMTK.
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
    std::uint64_t offset = 0;   // in the file (in what it inflates to, when deflated): of the value, or of
                                // its first item when encapsulated
    std::uint64_t claimed = 0;  // bytes, unless encapsulated
    std::uint64_t present = 0;  // of these, those that are there
    bool whole = false;         // to their end, with all fragments
};

struct Outline {
    bool nestedTooDeep = false;  // no real object has more than a dozen levels
    // Deflated, and far larger than its image: a megabyte can make a gigabyte.
    bool inflatesTooFar = false;
    // What stands before the pixel data is larger than any real header.
    bool headerTooLarge = false;
    // Everything before the pixel data could be read; without pixel data, up to the end of the file.
    bool headerWhole = false;
    std::optional<PixelDataOutline> pixels;
    // The pixel data are whole, and something follows that is no element.
    bool strayBytesAfterPixels = false;
    std::uint64_t datasetOffset = 0;  // in the file: where the file meta information ends
    // The UID of the file meta information; where there is none, that of what the dataset turned out to be.
    std::string transferSyntaxUid;

    // Within the bounds of any real object.
    bool isPlausible() const { return !nestedTooDeep && !inflatesTooFar && !headerTooLarge; }
};

// `hasPreamble`: the 128 bytes and DICM are there. `tree`, unless null, is filled with what stands before the
// pixel data, of the file meta information what is short. Thread-safe. May throw std::bad_alloc.
Outline outlineOf(ByteSource& source, bool hasPreamble, ElementTree* tree);
Outline outlineOf(const std::filesystem::path& file, bool hasPreamble);

}  // namespace macula::dicom
