// Reads the header of any PLY file (Turk 1994, "The PLY Polygon File Format").
#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"

namespace macula::splat {

enum class PlyFormat { ascii, littleEndian, bigEndian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t bytesOf(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::float32;
    std::optional<PlyType> countType;  // for a list: the type of its length
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;

    // The fewest bytes that one element takes in the file: lists may be empty, and an ascii number may be one
    // digit and a separator.
    std::uint64_t leastBytes(PlyFormat format) const;
    bool hasLists() const;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;   // in the order of the data
    std::vector<std::string> comments;  // without the word "comment"
    std::uint64_t bytes = 0;            // length of the header: the data begin here
};

// Leaves the stream at the start of the data. Fails with inputNotUsable when the file is not a PLY, the
// header is larger than 1 MiB or cut off, or a line makes no sense: a count below zero, an unknown type, a
// property before any element.
Result<PlyHeader> readPlyHeader(std::istream& stream);

}  // namespace macula::splat
