// The header of a PLY file (Turk 1994, "The PLY Polygon File Format"), of any PLY.
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
    std::optional<PlyType> countType;  // of a list: the type of its length
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;

    // The fewest bytes that one of them takes in the file: lists may be empty, an ascii number is one digit
    // and what parts it from the next.
    std::uint64_t leastBytes(PlyFormat format) const;
    bool hasLists() const;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;   // in the order of the data
    std::vector<std::string> comments;  // without the word
    std::uint64_t bytes = 0;            // where the data begin
};

// Leaves the stream at the data. Fails with inputNotUsable when it is no PLY, larger than 1 MiB, cut off, or
// has a line that makes no sense: a count below zero, an unknown type, a property before any element.
Result<PlyHeader> readPlyHeader(std::istream& stream);

}  // namespace macula::splat
