#include "scene/drawing/projection_windows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/volume/window.h"

namespace macula::scene {

namespace {

// A drag over the height of the picture makes the window this many times wider.
constexpr double kWidthPerHeight = 20.0;
constexpr double kNarrowest = 1e-3;  // of the volume's units
constexpr double kNarrowestLinear = 2.0;
constexpr double kWidestOfValues = 2.0;  // times their range

// The limits of a window that is dragged.
struct WindowReach {
    double widest;
    ValueRange centers;
};
WindowReach reachOf(const Volume& volume, const DisplayWindow& from) {
    const ValueRange values = volume.valueRange().value_or(ValueRange{from.center, from.center});
    WindowReach reach{std::max({kWidestOfValues * (values.high - values.low), from.width, kNarrowestLinear}),
                      {std::min(values.low, from.center), std::max(values.high, from.center)}};
    for (const DisplayWindow& window : volume.windows()) {
        reach.widest = std::max(reach.widest, window.width);
        reach.centers.low = std::min(reach.centers.low, window.center);
        reach.centers.high = std::max(reach.centers.high, window.center);
    }
    return reach;
}

}  // namespace

DisplayWindow SeriesWindows::of(trace::Look look, const Volume& volume) const {
    if (look != trace::Look::mip) {
        if (!series_) series_ = seriesWindow(volume);
        return *series_;
    }
    if (!maximum_) maximum_ = maximumWindow(volume);
    return *maximum_;
}

DisplayWindow dragged(const DisplayWindow& from, glm::dvec2 byHeights, const Volume& volume) {
    const WindowReach reach = reachOf(volume, from);
    DisplayWindow window = from;
    window.width = std::clamp(from.width * std::pow(kWidthPerHeight, byHeights.x), kNarrowest, reach.widest);
    // LINEAR needs a width of at least 1, where it is nearly a step (PS3.3 C.11.2.1.2.1).
    if (window.width < kNarrowestLinear && window.function != "SIGMOID") window.function = "LINEAR_EXACT";
    window.center = std::clamp(from.center + byHeights.y * from.width, reach.centers.low, reach.centers.high);
    return window;
}

std::string windowText(const DisplayWindow& window, const std::string& unit) {
    const int decimals = window.width >= 100.0 ? 0 : window.width >= 1.0 ? 1 : 4;
    const auto number = [&](double value) {
        // Whole numbers are written as such, and nothing as -0.
        const double scale = std::pow(10.0, decimals);
        const double rounded = std::round(value * scale) / scale;
        return rounded == std::round(rounded) ? fmt::format("{}", std::llround(rounded))
                                              : fmt::format("{:.{}f}", rounded, decimals);
    };
    const std::string text = fmt::format("W {} L {}", number(window.width), number(window.center));
    return unit.empty() ? text : text + " " + unit;
}

}  // namespace macula::scene
