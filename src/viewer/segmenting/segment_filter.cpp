#include "viewer/segmenting/segment_filter.h"

#include <QCoreApplication>
#include <cmath>

#include "segment/islands.h"

namespace macula::viewer {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(SegmentFilter)
};

}  // namespace

Result<VoxelSet> filtered(SegmentFilter filter, double amount, const VoxelSet& set,
                          const segment::SegmentGrid& grid, double voxelMl, Progress& progress) {
    switch (filter) {
        case SegmentFilter::largest:
            return segment::largestIsland(set, true, progress);
        case SegmentFilter::withoutSmall:
            return segment::withoutSmallIslands(set, std::size_t(std::ceil(amount / voxelMl - 1e-9)), true,
                                                progress);
        case SegmentFilter::median:
            return segment::medianOf(set, grid, amount, progress);
        case SegmentFilter::gaussian:
            return segment::gaussianOf(set, grid, amount, progress);
        case SegmentFilter::fillHoles:
            return segment::withoutHoles(set, progress);
        case SegmentFilter::fillBetween:
            return segment::filledBetweenSlices(set, grid, -1, progress);
        case SegmentFilter::grow:
            return segment::grownBy(set, grid, amount, progress);
        case SegmentFilter::shrink:
            return segment::shrunkBy(set, grid, amount, progress);
    }
    return set;
}

QString undoNameOf(SegmentFilter filter) {
    switch (filter) {
        case SegmentFilter::largest:
            return Words::tr("Largest part");
        case SegmentFilter::withoutSmall:
            return Words::tr("Small parts");
        case SegmentFilter::median:
        case SegmentFilter::gaussian:
            return Words::tr("Smoothing");
        case SegmentFilter::fillHoles:
            return Words::tr("Holes");
        case SegmentFilter::fillBetween:
            return Words::tr("Between slices");
        case SegmentFilter::grow:
            return Words::tr("Larger segment");
        case SegmentFilter::shrink:
            return Words::tr("Smaller segment");
    }
    return {};
}

}  // namespace macula::viewer
