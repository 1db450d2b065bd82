#include "scene/segments/segment_recipe.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "segment/islands.h"
#include "segment/shape_filters.h"
#include "segment/threshold.h"
#include "segment/voxel_sets.h"
#include "slices/sampled_slice.h"

namespace macula::scene {

namespace {

Result<VoxelSet> begun(const SegmentRecipe& recipe, const Volume& volume, Progress& progress) {
    VoxelSet found;
    if (recipe.threshold) {
        MACULA_TRY(found, segment::voxelsBetween(volume, *recipe.threshold, nullptr, progress));
    }
    if (!recipe.growFromMm) return found;
    const auto at = slices::probe(volume, *recipe.growFromMm);
    if (!at)
        return Error{ErrorCode::usage,
                     Text("The point lies outside of the volume."),
                     {},
                     Text("Give it in patient coordinates (LPS), in mm.")};
    if (recipe.tolerance) {
        MACULA_TRY(segment::Grown grown, segment::grownFrom(volume,
                                                            {.seed = at->voxel,
                                                             .tolerance = *recipe.tolerance,
                                                             .corners = recipe.overCorners,
                                                             .within = recipe.threshold ? &found : nullptr},
                                                            progress));
        return std::move(grown.voxels);
    }
    if (!found.contains(at->voxel))
        return Error{ErrorCode::usage,
                     Text("The value at the point is not within the threshold."),
                     {},
                     Text("Choose another point, or a wider threshold.")};
    return segment::islandOf(found, at->voxel, recipe.overCorners, progress);
}

}  // namespace

Result<VoxelSet> madeBy(const SegmentRecipe& recipe, const Volume& volume, Progress& progress) {
    if (!recipe.threshold && (!recipe.growFromMm || !recipe.tolerance))
        return Error{ErrorCode::usage,
                     Text("Nothing says where the segment begins."),
                     {},
                     Text("Give a threshold, or a point to grow from with a tolerance.")};
    const segment::SegmentGrid grid{volume.size(), volume.spacingMm()};
    MACULA_TRY(VoxelSet set, begun(recipe, volume, progress));
    if (recipe.largest) {
        MACULA_TRY(set, segment::largestIsland(set, recipe.overCorners, progress));
    }
    if (recipe.fewestMl) {
        const double voxels = std::ceil(*recipe.fewestMl / segment::voxelMl(volume.worldFromVoxel()) - 1e-9);
        constexpr double kMost = 1e15;
        const auto fewest = std::size_t(std::isfinite(voxels) ? std::clamp(voxels, 0.0, kMost) : 0.0);
        MACULA_TRY(set, segment::withoutSmallIslands(set, fewest, recipe.overCorners, progress));
    }
    if (recipe.fillsHoles) {
        MACULA_TRY(set, segment::withoutHoles(set, progress));
    }
    if (recipe.medianMm) {
        MACULA_TRY(set, segment::medianOf(set, grid, *recipe.medianMm, progress));
    }
    if (recipe.gaussianMm) {
        MACULA_TRY(set, segment::gaussianOf(set, grid, *recipe.gaussianMm, progress));
    }
    if (recipe.growMm) {
        MACULA_TRY(set, segment::grownBy(set, grid, *recipe.growMm, progress));
    }
    if (recipe.shrinkMm) {
        MACULA_TRY(set, segment::shrunkBy(set, grid, *recipe.shrinkMm, progress));
    }
    return set;
}

}  // namespace macula::scene
