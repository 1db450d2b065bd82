#include "slices/grey.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace macula::slices {

namespace {

// Both linear functions, with their divisions done: black up to and including `black`, white above `white`.
struct Ramp {
    double black = 0.0;
    double white = 0.0;
    double slope = 0.0;

    double operator()(double value) const {
        if (!(value > black)) return 0.0;  // NaN too
        if (value > white) return 1.0;
        return std::min((value - black) * slope, 1.0);
    }
};

// Black everywhere, because no value compares as above NaN.
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
constexpr Ramp kAllBlack{.black = kNoNumber, .white = kNoNumber, .slope = 0.0};

struct Sigmoid {
    double center = 0.0;
    double width = 1.0;

    double operator()(double value) const {
        if (std::isnan(value)) return 0.0;
        return 1.0 / (1.0 + std::exp(-4.0 * (value - center) / width));
    }
};

constexpr double kLeastWidth = std::numeric_limits<double>::min();

Ramp rampOf(const DisplayWindow& window) {
    if (window.function == "LINEAR_EXACT") {
        const double width = std::max(window.width, kLeastWidth);
        return {window.center - width / 2.0, window.center + width / 2.0, 1.0 / width};
    }
    const double width = std::max(window.width, 1.0);
    const double middle = window.center - 0.5;
    // A width of 1 has no slope, and no value between black and white.
    return {middle - (width - 1.0) / 2.0, middle + (width - 1.0) / 2.0,
            width > 1.0 ? 1.0 / (width - 1.0) : 0.0};
}

// Calls use(function) with the window's function, so that a loop over many values is compiled for each.
template <class Use>
auto withFunctionOf(const DisplayWindow& window, const Use& use) {
    if (!std::isfinite(window.center) || !std::isfinite(window.width)) return use(kAllBlack);
    if (window.function == "SIGMOID")
        return use(Sigmoid{.center = window.center, .width = std::max(window.width, kLeastWidth)});
    return use(rampOf(window));
}

}  // namespace

double greyOf(double value, const DisplayWindow& window) {
    return withFunctionOf(window, [&](const auto& grey) { return grey(value); });
}

std::vector<std::uint8_t> toGrey(std::span<const float> values, const DisplayWindow& window, bool inverted) {
    return withFunctionOf(window, [&](const auto& grey) {
        std::vector<std::uint8_t> bytes(values.size());
        for (std::size_t n = 0; n < values.size(); ++n) {
            if (std::isnan(values[n])) continue;
            const double toNearest = grey(values[n]) * 255.0 + 0.5;  // faster than std::lround
            const int shade = static_cast<int>(toNearest);
            bytes[n] = static_cast<std::uint8_t>(inverted ? 255 - shade : shade);
        }
        return bytes;
    });
}

}  // namespace macula::slices
