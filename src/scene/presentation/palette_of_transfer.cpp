#include "scene/presentation/palette_of_transfer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "base/srgb.h"

namespace macula::scene {

namespace {

constexpr double kAll = 65535.0;
constexpr double kFewestEntries = 2048.0;
constexpr double kMostEntries = 65536.0;
constexpr double kThinnest = 1e-6;  // a density below which nothing is visible

std::uint16_t levelOf(double part) {
    return std::uint16_t(std::lround(kAll * std::clamp(part, 0.0, 1.0)));
}

// The range of the curves' points. Curves are constant beyond it, so rounding it outwards changes nothing.
ValueRange rangeOf(const TransferFunction& function) {
    ValueRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    const auto hold = [&](double value) {
        range.low = std::min(range.low, value);
        range.high = std::max(range.high, value);
    };
    for (const OpacityPoint& point : function.opacity) hold(point.value);
    for (const ColourPoint& point : function.colour) hold(point.value);
    for (const OpacityPoint& point : function.steep.opacity) hold(point.value);
    for (const ColourPoint& point : function.steep.colour) hold(point.value);
    constexpr double kWhole = 16.0;  // from this span on, the range ends at whole numbers
    if (range.high - range.low >= kWhole) return {std::floor(range.low), std::ceil(range.high)};
    if (range.high > range.low) return range;
    return {range.low - 1.0, range.low + 1.0};
}

std::size_t entriesOver(const ValueRange& range) {
    const double span = range.high - range.low;
    if (span + 1.0 > kMostEntries) return std::size_t(kMostEntries);
    if (span != std::floor(span)) return std::size_t(2.0 * kFewestEntries) + 1;
    return std::size_t(span * std::max(1.0, std::ceil(kFewestEntries / span))) + 1;
}

double colourOf(const TransferFunction& function, double encoded) {
    return function.albedo == 1.0 ? encoded : encodedSrgb(function.albedo * decodedSrgb(encoded));
}

struct Shown {
    double opacity = 0.0;
    glm::dvec3 colour{0.0};  // encoded
};

// What other programs show at a value. They know one pair of curves: where there are two, they get the result
// for a gradient at which half of the matter is steep.
Shown shownAt(const TransferFunction& function, double value) {
    Shown shown{.opacity = opacityAt(function, value), .colour = colourAt(function, value)};
    if (!usesSteepCurves(function)) return shown;
    const TransferFunction steep = withCurvesSwapped(function);
    const double flat = extinctionPerMm(function, value);
    const double both = flat + extinctionPerMm(steep, value);
    if (!(both > 0.0)) return shown;
    const glm::dvec3 other = colourAt(steep, value);
    for (int c = 0; c < 3; ++c)
        shown.colour[c] =
            encodedSrgb(std::lerp(decodedSrgb(other[c]), decodedSrgb(shown.colour[c]), flat / both));
    shown.opacity = -std::expm1(-0.5 * both * layerMmOf(function));
    return shown;
}

// Picks entries so that straight lines between them stay near all others: from each, the farthest entry to
// which a straight line stays within a level of all entries between, in all tables at once.
std::vector<std::size_t> corners(std::span<const std::vector<std::uint16_t>* const> tables) {
    constexpr double kLevel = 1.01;
    const std::size_t count = tables.front()->size();
    std::vector<std::size_t> kept{0};
    std::vector<ValueRange> slopes(tables.size());
    const auto begin = [&] {
        std::ranges::fill(slopes, ValueRange{-std::numeric_limits<double>::infinity(),
                                             std::numeric_limits<double>::infinity()});
    };
    // Whether all entries between allow the slope to this one; if so, it narrows the allowed slopes.
    const auto reaches = [&](std::size_t from, std::size_t to) {
        for (std::size_t t = 0; t < tables.size(); ++t) {
            const double rise = double((*tables[t])[to]) - double((*tables[t])[from]);
            const double slope = rise / double(to - from);
            if (slope < slopes[t].low || slope > slopes[t].high) return false;
        }
        for (std::size_t t = 0; t < tables.size(); ++t) {
            const double rise = double((*tables[t])[to]) - double((*tables[t])[from]);
            slopes[t].low = std::max(slopes[t].low, (rise - kLevel) / double(to - from));
            slopes[t].high = std::min(slopes[t].high, (rise + kLevel) / double(to - from));
        }
        return true;
    };
    begin();
    for (std::size_t i = 1; i < count; ++i) {
        if (reaches(kept.back(), i)) continue;
        kept.push_back(i - 1);
        begin();
        reaches(kept.back(), i);
    }
    kept.push_back(count - 1);
    return kept;
}

}  // namespace

dicom::Palette paletteOf(const TransferFunction& function) {
    dicom::Palette palette{.values = rangeOf(function), .red = {}, .green = {}, .blue = {}, .alpha = {}};
    const std::size_t entries = entriesOver(palette.values);
    const double span = palette.values.high - palette.values.low;
    for (std::size_t i = 0; i < entries; ++i) {
        // Evaluated in this order, whole values are exact, and steps at them stay in place.
        const double value = palette.values.low + span * double(i) / double(entries - 1);
        const Shown shown = shownAt(function, value);
        palette.red.push_back(levelOf(colourOf(function, shown.colour.r)));
        palette.green.push_back(levelOf(colourOf(function, shown.colour.g)));
        palette.blue.push_back(levelOf(colourOf(function, shown.colour.b)));
        palette.alpha.push_back(levelOf(function.density < kThinnest ? 0.0 : shown.opacity));
    }
    return palette;
}

double layerMmOf(const TransferFunction& function) {
    return function.unitDistanceMm / (function.density < kThinnest ? 1.0 : function.density);
}

TransferFunction transferOf(const dicom::Palette& palette, double layerMm) {
    TransferFunction function;
    function.unitDistanceMm = layerMm;
    function.lighting.shade = false;
    function.effectiveRange = palette.values;
    const std::vector<std::uint16_t> ramp{0, 65535};
    const auto valueAt = [&](std::size_t i, std::size_t count) {
        return palette.values.low +
               (palette.values.high - palette.values.low) * double(i) / double(count - 1);
    };
    const bool isGrey = palette.red.empty();
    const std::array colours{isGrey ? &ramp : &palette.red, isGrey ? &ramp : &palette.green,
                             isGrey ? &ramp : &palette.blue};
    for (const std::size_t i : corners(colours))
        function.colour.push_back(
            {.value = valueAt(i, colours[0]->size()),
             .colour = glm::dvec3((*colours[0])[i], (*colours[1])[i], (*colours[2])[i]) / kAll});
    const std::array alpha{palette.alpha.empty() ? &ramp : &palette.alpha};
    for (const std::size_t i : corners(alpha))
        function.opacity.push_back(
            {.value = valueAt(i, alpha[0]->size()), .opacity = double((*alpha[0])[i]) / kAll});
    return function;
}

}  // namespace macula::scene
