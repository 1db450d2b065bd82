// The ways to draw a volume.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace macula::trace {

enum class Look {
    cinematic,  // path traced: light scatters as often as Settings::bounces says
    clear,      // path traced, scattered once: no light passes from matter to matter, so nothing glows
    dvr,        // ray cast: matter emits its colour and absorbs, without lights
    mip,        // the largest value along a ray, through a window
    minip,      // the smallest
    average,    // the mean over the length, as in an X-ray
};

// How a look's pictures are made.
enum class LookKind {
    paths,   // random light paths: path.comp
    matter,  // matter under a transfer function, ray-marched deterministically: cast.comp
    values,  // values through a window, ray-marched deterministically: cast.comp
};

// The one table of looks. `--look` and the window's menu are made from it.
struct LookTraits {
    Look look;
    LookKind kind;
    std::string_view name;   // as in --look and in files
    std::string_view title;  // for people
};
inline constexpr std::array<LookTraits, 6> kLooks{
    {{Look::cinematic, LookKind::paths, "cinematic", "Cinematic"},
     {Look::clear, LookKind::paths, "clear", "Clear"},
     {Look::dvr, LookKind::matter, "dvr", "Ray cast"},
     {Look::mip, LookKind::values, "mip", "Maximum (MIP)"},
     {Look::minip, LookKind::values, "minip", "Minimum (MinIP)"},
     {Look::average, LookKind::values, "average", "Average (X-ray)"}}};

constexpr const LookTraits& traitsOf(Look look) {
    return kLooks.at(static_cast<std::size_t>(look));
}
static_assert(
    [] {
        for (std::size_t i = 0; i < kLooks.size(); ++i) {
            if (static_cast<std::size_t>(kLooks[i].look) != i) return false;
        }
        return static_cast<std::size_t>(Look::average) + 1 == kLooks.size();
    }(),
    "the table has the looks in the order of the enumeration, all of them");

constexpr std::string_view nameOf(Look look) {
    return traitsOf(look).name;
}

// Nothing for a name that no look has.
constexpr std::optional<Look> lookNamed(std::string_view name) {
    for (const LookTraits& known : kLooks) {
        if (known.name == name) return known.look;
    }
    return std::nullopt;
}

constexpr bool isPathTraced(Look look) {
    return traitsOf(look).kind == LookKind::paths;
}
constexpr bool isProjection(Look look) {
    return traitsOf(look).kind == LookKind::values;
}
constexpr bool showsMatter(Look look) {
    return !isProjection(look);
}

}  // namespace macula::trace
