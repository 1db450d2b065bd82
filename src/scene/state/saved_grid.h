// Where the voxels lay that a view was saved of: camera, clips and measurements are of these places.
#pragma once

#include "base/volume.h"

namespace macula::app {

struct SavedGrid {
    glm::ivec3 size{0};
    glm::dmat4 worldFromVoxel{1.0};

    bool operator==(const SavedGrid&) const = default;
};

SavedGrid savedGridOf(const Volume& volume);

// As many voxels, each in its place to a hundredth of a millimetre. Images that were exported anew keep their
// UIDs, and may not.
bool liesAt(const Volume& volume, const SavedGrid& grid);

}  // namespace macula::app
