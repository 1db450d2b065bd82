// The ways to draw a volume.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace macula::trace {

enum class Look {
    cinematic,  // path traced: light scatters as often as Settings::bounces says
    clear,      // path traced, scattered once: no light from matter to matter, so nothing glows
    dvr,        // ray cast: matter emits its colour and absorbs, no light is needed
    mip,        // the largest value along a ray, through a window
    minip,      // the smallest
    average,    // the mean over the length, as in an X-ray
};

struct LookName {
    Look look;
    std::string_view name;   // as in --look
    std::string_view title;  // for people
};
inline constexpr std::array<LookName, 6> kLooks{{{Look::cinematic, "cinematic", "Cinematic"},
                                                 {Look::clear, "clear", "Clear"},
                                                 {Look::dvr, "dvr", "Ray cast"},
                                                 {Look::mip, "mip", "Maximum (MIP)"},
                                                 {Look::minip, "minip", "Minimum (MinIP)"},
                                                 {Look::average, "average", "Average (X-ray)"}}};

constexpr std::string_view nameOf(Look look) {
    for (const LookName& known : kLooks) {
        if (known.look == look) return known.name;
    }
    return {};
}

// Random light paths; else one march for each sample, the same every time.
constexpr bool isPathTraced(Look look) {
    return look == Look::cinematic || look == Look::clear;
}
// Values through a window, not matter under a transfer function.
constexpr bool isProjection(Look look) {
    return look == Look::mip || look == Look::minip || look == Look::average;
}

}  // namespace macula::trace
