// Which slices of a volume are shown first, and largest.
#pragma once

#include <optional>

#include "slices/slice_plane.h"

namespace macula::scene {

struct OpeningPlanes {
    // In the planes of the acquisition, if these are tilted by more than 5 degrees against the patient's: a
    // plane of the patient would then cross many images.
    bool asAcquired = false;
    // The images' orientation, if the stack is thinner than 0.4 of their shorter side: the other panes show
    // only narrow strips.
    std::optional<slices::Orientation> largest = {};

    bool operator==(const OpeningPlanes&) const = default;
};

OpeningPlanes openingPlanes(const Volume& volume);

}  // namespace macula::scene
