// The filters that a person applies to an own segment.
#pragma once

#include <QString>

#include "base/progress.h"
#include "base/result.h"
#include "base/voxel_set.h"
#include "segment/shape_filters.h"

namespace macula::viewer {

enum class SegmentFilter { largest, withoutSmall, median, gaussian, fillHoles, fillBetween, grow, shrink };

// `amount` in mm, in ml for withoutSmall, and of no meaning for others. Fails as the functions of
// src/segment.
Result<VoxelSet> filtered(SegmentFilter filter, double amount, const VoxelSet& set,
                          const segment::SegmentGrid& grid, double voxelMl, Progress& progress);

QString undoNameOf(SegmentFilter filter);

}  // namespace macula::viewer
