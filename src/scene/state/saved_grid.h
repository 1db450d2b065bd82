// The voxel grid that a view was saved with: its camera, clips and measurements refer to these places.
#pragma once

#include "base/volume.h"

namespace macula::scene {

struct SavedGrid {
    glm::ivec3 size{0};
    glm::dmat4 worldFromVoxel{1.0};

    bool operator==(const SavedGrid&) const = default;
};

SavedGrid savedGridOf(const Volume& volume);

// Whether the volume has the same size, and each voxel lies within 0.01 mm of its place in `grid`. Images
// that are exported again keep their UIDs, but may have other positions.
bool liesAt(const Volume& volume, const SavedGrid& grid);

}  // namespace macula::scene
