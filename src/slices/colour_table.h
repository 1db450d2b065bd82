// Colours for values that lie over a slice.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "base/volume.h"

namespace macula::slices {

enum class ColourTable {
    hotIron,  // from black over red and yellow to white: PS3.6 B.1.1
    green,
    grey,
};
inline constexpr std::array kColourTables{ColourTable::hotIron, ColourTable::green, ColourTable::grey};

// The name in files.
constexpr std::string_view nameOf(ColourTable table) {
    switch (table) {
        case ColourTable::hotIron:
            return "hotIron";
        case ColourTable::green:
            return "green";
        case ColourTable::grey:
            return "grey";
    }
    return {};
}

struct Rgb {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
    bool operator==(const Rgb&) const = default;
};
Rgb colourOf(ColourTable table, std::uint8_t grey);

// One pixel for each value, 0xAARRGGBB, premultiplied; NaN is transparent. Opacity rises from 0 over the
// lowest quarter of the window, so that regions without uptake hide nothing; for grey it is the same
// everywhere. `opacity` from 0 to 1.
std::vector<std::uint32_t> toColours(std::span<const float> values, const DisplayWindow& window,
                                     bool inverted, ColourTable table, double opacity);

}  // namespace macula::slices
