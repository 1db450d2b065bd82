// Datasets in the DICOM JSON model (PS3.18 F.2), as archives answer with it.
//
// Archives differ in how they write it, so that much is let through: numbers as text and text as numbers,
// values without an array, names that are no objects. The parser does not recurse, and bounds depth and
// counts.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace macula::net {

struct JsonDataset;

struct JsonElement {
    std::uint32_t tag = 0;            // (gggg,eeee) as 0xggggeeee
    std::vector<std::string> values;  // in UTF-8, without padding; names as alphabetic=ideographic=phonetic
    std::vector<JsonDataset> items;   // of a sequence
};

struct JsonDataset {
    std::vector<JsonElement> elements;

    const JsonElement* find(std::uint32_t tag) const;
    std::string first(std::uint32_t tag) const;  // the first value, or nothing
    std::span<const std::string> values(std::uint32_t tag) const;
    std::span<const JsonDataset> items(std::uint32_t tag) const;
};

// The datasets of an array, or the only one; of each the elements in `wanted` alone. Fails with
// archiveNotUsable where the text is no JSON, nested too deep, or holds more than `mostDatasets`.
Result<std::vector<JsonDataset>> dicomJsonOf(std::string_view text, std::span<const std::uint32_t> wanted,
                                             std::size_t mostDatasets);

}  // namespace macula::net
