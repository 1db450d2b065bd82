// Reads Palette Color Lookup Tables of a data set (PS3.3 C.7.6.3.1.5 and C.7.9.2).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dicom/read/dataset.h"

namespace macula::dicom {

struct PaletteTable {
    int firstValue = 0;                 // the value that the first entry maps
    std::vector<std::uint16_t> values;  // 65535 is full, for tables of 8 bits too; at least 2
};

// Reads a table of 8 or 16 bits, plain or segmented. Nothing when a part is missing or does not fit.
std::optional<PaletteTable> readPaletteTable(const Dataset& from, Tag descriptor, Tag data, Tag segmented);

// Expands segments to entries; nothing unless there are exactly `count` entries, at most 65536.
std::optional<std::vector<std::uint16_t>> expandSegments(std::span<const std::uint16_t> words,
                                                         std::size_t count);

}  // namespace macula::dicom
