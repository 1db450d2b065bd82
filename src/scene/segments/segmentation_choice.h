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

namespace macula::app {

// What a segment does to the volume in 3D. Of several that are alone, all are seen; what is hidden is hidden.
enum class In3d { asIs, alone, hidden };
inline constexpr std::array kIn3d{In3d::asIs, In3d::alone, In3d::hidden};

// As in files.
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

struct SegmentChoice {
    std::uint16_t number = 1;
    bool isVisible = true;                                // on slices
    std::optional<std::array<std::uint8_t, 3>> rgb = {};  // sRGB; nothing: what the file recommends
    double opacity = kUsualSegmentOpacity;                // of what is filled on slices
    In3d in3d = In3d::asIs;
    bool isColouredIn3d = false;  // its colour is that of the matter in it
    double opacityIn3d = 1.0;     // where it is coloured: how much of that matter is left

    bool operator==(const SegmentChoice&) const = default;
};

struct SegmentationChoice {
    std::string digest;                        // SHA-256 of its SOP Instance UID
    bool isShown = false;                      // else it changes nothing, on slices or in 3D
    std::vector<SegmentChoice> segments = {};  // by number; others are as by default

    bool operator==(const SegmentationChoice&) const = default;
};

// As by default where nobody chose.
SegmentationChoice choiceOf(std::span<const SegmentationChoice> choices, std::string_view digest);
SegmentChoice choiceOf(const SegmentationChoice& choice, std::uint16_t number);

// Sets it, and keeps nothing of what is as by default: equal choices compare equal.
void choose(std::vector<SegmentationChoice>& choices, SegmentationChoice choice);
void choose(std::vector<SegmentationChoice>& choices, std::string_view digest, const SegmentChoice& segment);

// The same, but for what they do in 3D.
std::vector<SegmentationChoice> onSlicesAlone(std::span<const SegmentationChoice> choices);

// What of all this hides something in 3D.
using In3dOf = std::tuple<std::string, std::uint16_t, In3d>;  // digest, number
std::vector<In3dOf> in3dOf(std::span<const SegmentationChoice> choices);
// The colours that change it: digest, number, colour as in SegmentChoice, opacity.
using ColouredIn3d =
    std::tuple<std::string, std::uint16_t, std::optional<std::array<std::uint8_t, 3>>, double>;
std::vector<ColouredIn3d> colouredIn3dOf(std::span<const SegmentationChoice> choices);
// The same, but coloured in 3D that and nothing else, in these colours on slices too. What is coloured there
// is shown.
std::vector<SegmentationChoice> withColoursIn3d(std::span<const SegmentationChoice> choices,
                                                std::span<const ColouredIn3d> coloured);
// The same on slices and in colour, and hidden in 3D that and nothing else: in3dOf() of it is `in3d`. What
// does something there is shown.
std::vector<SegmentationChoice> withIn3d(std::span<const SegmentationChoice> choices,
                                         std::span<const In3dOf> in3d);

}  // namespace macula::app
