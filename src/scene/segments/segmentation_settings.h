// How the segmentations of a study are shown.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace macula::scene {

// What a segment does to the volume in 3D. If any are `alone`, only these are shown; `hidden` always hides.
enum class In3d { asIs, alone, hidden };
inline constexpr std::array kIn3d{In3d::asIs, In3d::alone, In3d::hidden};

// The name in files.
constexpr std::string_view nameOf(In3d in3d) {
    switch (in3d) {
        case In3d::asIs:
            return "asIs";
        case In3d::alone:
            return "alone";
        case In3d::hidden:
            return "hidden";
    }
    return {};
}

inline constexpr double kUsualSegmentOpacity = 0.4;

struct SegmentSettings {
    std::uint16_t number = 1;
    bool isVisible = true;                                // on slices
    std::optional<std::array<std::uint8_t, 3>> rgb = {};  // sRGB; nothing: what the file recommends
    double opacity = kUsualSegmentOpacity;                // opacity of the fill on slices
    In3d in3d = In3d::asIs;
    bool isColouredIn3d = false;  // the matter in it takes the segment's colour
    double opacityIn3d = 1.0;     // share of the extinction that a coloured segment keeps

    bool operator==(const SegmentSettings&) const = default;
};

struct SegmentationSettings {
    std::string digest;                          // SHA-256 of its SOP Instance UID
    bool isShown = false;                        // otherwise it changes nothing, on slices or in 3D
    std::vector<SegmentSettings> segments = {};  // sorted by number; others have the defaults

    bool operator==(const SegmentationSettings&) const = default;
};

// The stored choice, or the default if there is none.
SegmentationSettings choiceOf(std::span<const SegmentationSettings> choices, std::string_view digest);
SegmentSettings choiceOf(const SegmentationSettings& choice, std::uint16_t number);

// Sets the choice and drops entries that equal the defaults, so that equal choices compare equal.
void choose(std::vector<SegmentationSettings>& choices, SegmentationSettings choice);
void choose(std::vector<SegmentationSettings>& choices, std::string_view digest,
            const SegmentSettings& segment);

// The choices without their effects in 3D.
std::vector<SegmentationSettings> onSlicesAlone(std::span<const SegmentationSettings> choices);

// The segments of shown segmentations that change what is visible in 3D.
using In3dOf = std::tuple<std::string, std::uint16_t, In3d>;  // digest, number
std::vector<In3dOf> in3dOf(std::span<const SegmentationSettings> choices);
// The segments coloured in 3D: digest, number, colour as in SegmentSettings, opacity.
using ColouredIn3d =
    std::tuple<std::string, std::uint16_t, std::optional<std::array<std::uint8_t, 3>>, double>;
std::vector<ColouredIn3d> colouredIn3dOf(std::span<const SegmentationSettings> choices);
// Replaces the 3D colours of the shown segmentations, and of those in `coloured`, which become shown, by
// `coloured`; these colours apply on slices too.
std::vector<SegmentationSettings> withColoursIn3d(std::span<const SegmentationSettings> choices,
                                                  std::span<const ColouredIn3d> coloured);
// Sets in3d of the segments so that in3dOf() returns `in3d`; their other fields stay. The segmentations in
// `in3d` become shown.
std::vector<SegmentationSettings> withIn3d(std::span<const SegmentationSettings> choices,
                                           std::span<const In3dOf> in3d);

}  // namespace macula::scene
