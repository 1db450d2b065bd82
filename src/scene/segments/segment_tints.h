// Segments that have a colour of their own in 3D.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "base/voxel_set.h"
#include "pipeline/volume/additions.h"
#include "scene/segments/segment_mask.h"
#include "scene/segments/segmentation_settings.h"

namespace macula::scene {

// The voxels of each colour index, without the colours: all that a TintBox depends on.
struct TintGeometry {
    struct Part {
        std::shared_ptr<const VoxelSet> voxels;
        std::uint8_t colour = 1;  // 1 + its index

        bool operator==(const Part&) const = default;  // compares pointers: parts of one set
    };
    std::vector<Part> parts;  // where parts overlap, the later one counts

    bool operator==(const TintGeometry&) const = default;
};

// The colour table for segments in 3D, and which entry each segment has. It is planned from what was chosen
// (in3dOf) and reads no voxels. Each segment has an entry of its own, so that another colour or opacity
// changes the table and not the geometry; of more than 255 segments, those of one colour share an entry.
// Segments without a voxel in the volume, and those whose segmentation is not loaded, are left out. Error:
// inputNotUsable for more than 255 different colours of more than 255 segments.
struct PlannedTints {
    TintGeometry geometry;
    std::vector<SegmentTints::Colour> colours;
};
Result<PlannedTints> plannedTints(std::span<const SegmentationSettings> choices,
                                  const LoadedSegmentations& loaded);

// `geometry` has at least one part. Errors: cancelled, outOfMemory.
Result<std::shared_ptr<const TintBox>> tintBox(const TintGeometry& geometry, const Volume& volume,
                                               Progress& progress);

// Calls plannedTints, then tintBox; nothing where no segment is coloured.
Result<std::optional<SegmentTints>> segmentTints(std::span<const SegmentationSettings> choices,
                                                 const LoadedSegmentations& loaded, const Volume& volume,
                                                 Progress& progress);

}  // namespace macula::scene
