// Which slices of a volume are shown first, and largest.
#pragma once

#include <optional>

#include "slices/slice_plane.h"

namespace macula::scene {

struct OpeningPlanes {
    // In the planes of the acquisition, if they are tilted by more than 5 degrees to the patient's: planes of
    // the patient would then show parts of many images.
    bool asAcquired = false;
    // The images' orientation, if the stack is thinner than 0.4 of their shorter side: others show strips.
    std::optional<slices::Orientation> largest = {};

    bool operator==(const OpeningPlanes&) const = default;
};

OpeningPlanes openingPlanes(const Volume& volume);

}  // namespace macula::scene
