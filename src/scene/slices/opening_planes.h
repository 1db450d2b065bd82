// Which slices of a volume are shown first, and largest.
#pragma once

#include <optional>

#include "slices/slice_plane.h"

namespace macula::app {

struct OpeningPlanes {
    // In the planes of the acquisition: those are turned so far against the patient's that planes of the
    // patient would show parts of many images.
    bool asAcquired = false;
    // The orientation of the images, where a stack is so thin that the two others show strips.
    std::optional<slices::Orientation> largest = {};

    bool operator==(const OpeningPlanes&) const = default;
};

OpeningPlanes openingPlanes(const Volume& volume);

}  // namespace macula::app
