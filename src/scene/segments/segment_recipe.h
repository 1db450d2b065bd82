// One segment made of a volume without a hand, as the command makes it.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "base/voxel_set.h"

namespace macula::scene {

// Steps are taken in this order; what is not given is left out. At least one of the first two is needed.
struct SegmentRecipe {
    std::optional<ValueRange> threshold = {};   // in the unit of the volume
    std::optional<glm::dvec3> growFromMm = {};  // patient LPS: what is connected with the voxel nearest to it
    // Grows over values so far from the mean around the point; nothing: over those of the threshold, which
    // must be given then.
    std::optional<double> tolerance = {};
    bool overCorners = false;
    bool largest = false;
    std::optional<double> fewestMl = {};  // of a connected part that stays
    bool fillsHoles = false;
    std::optional<double> medianMm = {};
    std::optional<double> gaussianMm = {};
    std::optional<double> growMm = {};
    std::optional<double> shrinkMm = {};
};

// Cropped; may be empty. Errors: usage for a recipe without a beginning, or a point outside of the volume or
// of the values; those of src/segment.
Result<VoxelSet> madeBy(const SegmentRecipe& recipe, const Volume& volume, Progress& progress);

}  // namespace macula::scene
