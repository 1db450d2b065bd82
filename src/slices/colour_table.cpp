#include "slices/colour_table.h"

#include <algorithm>
#include <cmath>

#include "slices/grey.h"

namespace macula::slices {

namespace {

constexpr double kComesUp = 64.0;  // greys, of 255, over which opacity rises

std::uint32_t premultiplied(Rgb colour, double alpha) {
    const auto part = [](double value) { return std::uint32_t(std::lround(value)); };
    return part(255.0 * alpha) << 24U | part(colour.red * alpha) << 16U | part(colour.green * alpha) << 8U |
           part(colour.blue * alpha);
}

}  // namespace

Rgb colourOf(ColourTable table, std::uint8_t grey) {
    const int at = grey;
    const auto ramp = [at](int from, int slope) {
        return static_cast<std::uint8_t>(std::clamp((at - from) * slope, 0, 255));
    };
    switch (table) {
        case ColourTable::hotIron:
            return {ramp(0, 2), ramp(128, 2), ramp(192, 4)};
        case ColourTable::green:
            return {0, grey, 0};
        case ColourTable::grey:
            break;
    }
    return {grey, grey, grey};
}

std::vector<std::uint32_t> toColours(std::span<const float> values, const DisplayWindow& window,
                                     bool inverted, ColourTable table, double opacity) {
    const double most = std::isfinite(opacity) ? std::clamp(opacity, 0.0, 1.0) : 0.0;
    std::array<std::uint32_t, 256> colours{};
    for (std::size_t grey = 0; grey < colours.size(); ++grey) {
        const double shown =
            table == ColourTable::grey ? most : most * std::min(1.0, double(grey) / kComesUp);
        colours[grey] = premultiplied(colourOf(table, std::uint8_t(grey)), shown);
    }
    const std::vector<std::uint8_t> greys = toGrey(values, window, inverted);
    std::vector<std::uint32_t> pixels(values.size(), 0U);
    for (std::size_t n = 0; n < values.size(); ++n)
        if (!std::isnan(values[n])) pixels[n] = colours[greys[n]];
    return pixels;
}

}  // namespace macula::slices
