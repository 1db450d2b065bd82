#include "pipeline/splat/files/ply_layout.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>

namespace macula::splat {

namespace {

// The name of the property for each slot.
constexpr std::array<std::string_view, PlyLayout::kRest> kNames{
    "x",       "y",       "z",     "f_dc_0", "f_dc_1", "f_dc_2", "opacity",  "scale_0",
    "scale_1", "scale_2", "rot_0", "rot_1",  "rot_2",  "rot_3",  "filter_3D"};
constexpr std::array<std::string_view, 3> kColours{"red", "green", "blue"};

constexpr std::size_t kMostRest = 1000;

Error unusable(Text message, Text hint = Text("Export the model again from where it came.")) {
    return {ErrorCode::inputNotUsable, std::move(message), {}, std::move(hint)};
}

bool has(const PlyElement& vertex, std::string_view name) {
    return std::any_of(vertex.properties.begin(), vertex.properties.end(),
                       [&](const PlyProperty& p) { return p.name == name; });
}

template <std::size_t n>
std::optional<std::size_t> indexIn(const std::array<std::string_view, n>& names, std::string_view name) {
    const auto* found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return static_cast<std::size_t>(found - names.begin());
}

// The number after "f_rest_", or nothing.
std::optional<std::size_t> restIndex(std::string_view name) {
    constexpr std::string_view kRestName = "f_rest_";
    if (!name.starts_with(kRestName)) return std::nullopt;
    name.remove_prefix(kRestName.size());
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), index);
    if (error != std::errc() || end != name.data() + name.size() || index > kMostRest) return std::nullopt;
    return index;
}

std::size_t slotOf(const PlyProperty& property, bool hasColourBytes) {
    if (const auto slot = indexIn(kNames, property.name)) return *slot;
    if (const auto index = restIndex(property.name)) return PlyLayout::kRest + *index;
    if (const auto channel = indexIn(kColours, property.name); channel && hasColourBytes)
        return PlyLayout::kDc + *channel;
    return property.name == "filter_3d" ? std::size_t{PlyLayout::kFilter} : PlyLayout::kNone;
}

// The degree that has `rest` coefficients of colour besides the constant ones, over all channels.
std::optional<int> degreeOf(std::size_t rest) {
    for (int degree = 0; degree <= kMaxShDegree; ++degree) {
        if (3 * shCount(degree) == rest) return degree;
    }
    return std::nullopt;
}

std::string missingIn(const PlyLayout& layout, const std::vector<bool>& seen) {
    std::string missing;
    for (std::size_t slot = 0; slot < PlyLayout::kRest; ++slot) {
        if (seen[slot] || slot == PlyLayout::kFilter || (slot == PlyLayout::kScale + 2 && layout.isFlat))
            continue;
        missing += fmt::format("{}{}", missing.empty() ? "" : ", ", kNames[slot]);
    }
    return missing;
}

}  // namespace

Result<PlyLayout> plyLayoutOf(const PlyElement& vertex) {
    PlyLayout layout;
    layout.hasColourBytes =
        !has(vertex, "f_dc_0") && has(vertex, "red") &&
        std::all_of(vertex.properties.begin(), vertex.properties.end(),
                    [](const auto& p) { return p.type == PlyType::uint8 || !indexIn(kColours, p.name); });
    layout.isFlat = has(vertex, "scale_1") && !has(vertex, "scale_2");
    std::vector<bool> seen(PlyLayout::kRest + kMostRest + 1, false);
    std::size_t rest = 0;
    for (const PlyProperty& property : vertex.properties) {
        const std::size_t slot = slotOf(property, layout.hasColourBytes);
        layout.slots.push_back(slot);
        if (slot == PlyLayout::kNone) continue;
        if (property.countType)
            return unusable(Text("The PLY file has a list in the place of {}.", property.name));
        if (seen[slot]) return unusable(Text("The PLY file has {} twice.", property.name));
        seen[slot] = true;
        rest += slot >= PlyLayout::kRest ? 1 : 0;
    }
    layout.hasFilter = seen[PlyLayout::kFilter];
    if (const std::string missing = missingIn(layout, seen); !missing.empty())
        return unusable(
            Text("The PLY file is no model of Gaussians: it lacks {}.", missing),
            Text("Choose a model as 3D Gaussian splatting writes it, not a mesh or a point cloud."));
    const auto degree = degreeOf(rest);
    if (!degree || !std::all_of(seen.begin() + PlyLayout::kRest,
                                seen.begin() + static_cast<std::ptrdiff_t>(PlyLayout::kRest + rest),
                                [](bool is) { return is; }))
        return unusable(
            Text("The PLY file has {} coefficients of colour f_rest; 0, 9, 24 or 45 without a gap are "
                 "understood.",
                 rest),
            Text("Export it with spherical harmonics of degree 3 or less."));
    layout.shDegree = *degree;
    return layout;
}

}  // namespace macula::splat
