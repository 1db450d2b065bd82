// Cuts made from a camera's view, in addition to a volume's clip; and named clips. World frame: patient LPS,
// mm.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/camera.h"
#include "pipeline/volume/clip.h"
#include "scene/clip/kept_box.h"
#include "scene/clip/shared_outline.h"

namespace macula::scene {

// A plane across the line of sight that removes what lies before it. Only `plane` cuts; the other fields say
// how it changes when the camera moves.
struct EyeCut {
    HalfSpace plane;
    // The requested distance from the middle of the volume's box along the normal; negative: towards the eye.
    // `plane` is nearer if the box ends before that.
    double fromMiddleMm = 0.0;
    bool followsCamera = true;  // if not, it stays where it is in the patient

    bool operator==(const EyeCut&) const = default;
};

// An outline drawn over a picture. Removes what lies behind it along the rays of `camera`, or everything
// else.
struct ScissorCut {
    Camera camera;
    SharedOutline outline;  // in half heights from the middle of the picture, right and up positive
    bool removesOutside = false;

    bool operator==(const ScissorCut&) const = default;
};

inline constexpr std::size_t kMostScissorCuts = 50;
inline constexpr std::size_t kMostOutlinePoints = 500;

struct Cuts {
    std::optional<EyeCut> eye = {};
    std::vector<ScissorCut> scissors = {};  // at most kMostScissorCuts, in the order in which they were made

    bool isNothing() const { return !eye && scissors.empty(); }
    bool operator==(const Cuts&) const = default;
};

inline constexpr std::size_t kMostNamedClips = 100;
inline constexpr std::size_t kLongestClipNameBytes = 200;  // in UTF-8

struct NamedClip {
    std::string name;  // typed by a user; may identify a person
    OptionalClip clip = {};
    Cuts cuts = {};

    bool operator==(const NamedClip&) const = default;
};

}  // namespace macula::scene
