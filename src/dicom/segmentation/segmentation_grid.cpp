#include "dicom/segmentation/segmentation_grid.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace macula::dicom {

namespace {

// Places a frame that lies in the plane of a slice slightly off the even grid, as if both lay on the grid.
std::optional<GridPlacement> placeOnSlice(const Segmentation& segmentation, ImagePlane plane,
                                          const glm::dmat4& worldFromVoxel, const glm::dmat4& voxelFromWorld,
                                          std::span<const glm::dvec3> slicePositionsMm) {
    const double along = transformPoint(voxelFromWorld, plane.positionMm).z;
    const double last = static_cast<double>(slicePositionsMm.size()) - 1.0;
    if (!(along > -1.0 && along < last + 1.0)) return {};
    const glm::dvec3 positionMm = plane.positionMm;
    for (const double k : {std::round(along), std::floor(along), std::ceil(along)}) {
        if (k < 0.0 || k > last) continue;
        const glm::dvec3 even = transformPoint(worldFromVoxel, {0.0, 0.0, k});
        plane.positionMm = positionMm + even - slicePositionsMm[static_cast<std::size_t>(k)];
        auto placement = placeOnGrid(voxelFromWorld, plane, segmentation.columns, segmentation.rows);
        // A frame across the slices belongs to no single slice.
        if (placement && placement->origin.z == static_cast<int>(k) && placement->columnStep.z == 0 &&
            placement->rowStep.z == 0) {
            return placement;
        }
    }
    return {};
}

// Axes that could be those of a grid that holds all frames: along the normal, or from the lowest frame to the
// highest; as far apart as the header says, or as the two nearest are.
std::vector<glm::dvec3> likelySliceAxes(const Segmentation& segmentation) {
    const auto& frames = segmentation.frames;
    const glm::dvec3 normal = glm::normalize(frames.front().plane.normal());
    const auto height = [&](const Segmentation::Frame& f) { return glm::dot(f.plane.positionMm, normal); };
    const auto [lowest, highest] = std::minmax_element(
        frames.begin(), frames.end(), [&](const auto& a, const auto& b) { return height(a) < height(b); });
    const double distance = height(*highest) - height(*lowest);
    const double stated = segmentation.spacingMm;
    if (distance < kSamePositionMm) return {normal * (stated > 0.0 ? stated : 1.0)};

    std::vector<double> heights;
    for (const auto& frame : frames) heights.push_back(height(frame));
    std::sort(heights.begin(), heights.end());
    double nearest = distance;
    for (std::size_t i = 1; i < heights.size(); ++i) {
        if (const double gap = heights[i] - heights[i - 1]; gap >= kSamePositionMm)
            nearest = std::min(nearest, gap);
    }
    std::vector<glm::dvec3> axes;
    for (const double spacing : {stated, nearest}) {
        if (spacing <= 0.0) continue;
        const double steps = std::round(distance / spacing);
        if (steps < 1.0) continue;
        // The step comes from the whole length, so that the error of a rounded spacing does not add up.
        axes.push_back(normal * (distance / steps));
        axes.push_back((highest->plane.positionMm - lowest->plane.positionMm) / steps);
    }
    return axes;
}

constexpr double kToleranceVoxels = 0.01;
constexpr double kFarthest = 1e6;  // voxels: farther is never meant, and sums stay within an int

bool isNear(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 difference = glm::abs(a - b);
    return difference.x <= kToleranceVoxels && difference.y <= kToleranceVoxels &&
           difference.z <= kToleranceVoxels;
}

// The nearest step of one voxel along one axis.
std::optional<glm::ivec3> unitStep(const glm::dvec3& step) {
    const glm::dvec3 rounded = glm::round(step);
    if (std::abs(rounded.x) + std::abs(rounded.y) + std::abs(rounded.z) != 1.0) return {};
    return glm::ivec3(rounded);
}

}  // namespace

std::optional<Placements> placeFrames(const Segmentation& segmentation, const glm::dmat4& worldFromVoxel,
                                      std::span<const glm::dvec3> slicePositionsMm, std::size_t* firstOff) {
    if (!isInvertibleAffine(worldFromVoxel)) return {};
    const glm::dmat4 voxelFromWorld = glm::inverse(worldFromVoxel);
    Placements placements;
    placements.reserve(segmentation.frames.size());
    for (const Segmentation::Frame& frame : segmentation.frames) {
        auto placement = placeOnGrid(voxelFromWorld, frame.plane, segmentation.columns, segmentation.rows);
        if (!placement && !slicePositionsMm.empty()) {
            placement =
                placeOnSlice(segmentation, frame.plane, worldFromVoxel, voxelFromWorld, slicePositionsMm);
        }
        if (!placement) {
            if (firstOff != nullptr) *firstOff = placements.size();
            return {};
        }
        placements.push_back(*placement);
    }
    return placements;
}

std::optional<SegmentationGrid> ownGrid(const Segmentation& segmentation) {
    if (segmentation.frames.empty()) return {};
    const ImagePlane& plane = segmentation.frames.front().plane;
    for (const glm::dvec3& sliceAxis : likelySliceAxes(segmentation)) {
        glm::dmat4 worldFromVoxel =
            affine(plane.columnSpacingMm * plane.rowDirection, plane.rowSpacingMm * plane.columnDirection,
                   sliceAxis, plane.positionMm);
        auto placements = placeFrames(segmentation, worldFromVoxel);
        if (!placements) continue;
        glm::ivec3 low = placements->front().origin;
        glm::ivec3 high = low;
        for (const GridPlacement& p : *placements) {
            for (const glm::ivec3& corner : {p.origin, p.origin + (segmentation.columns - 1) * p.columnStep +
                                                           (segmentation.rows - 1) * p.rowStep}) {
                low = glm::min(low, corner);
                high = glm::max(high, corner);
            }
        }
        worldFromVoxel[3] = worldFromVoxel * glm::dvec4(glm::dvec3(low), 1.0);
        for (GridPlacement& p : *placements) p.origin -= low;
        return SegmentationGrid{worldFromVoxel, high - low + glm::ivec3(1), *std::move(placements)};
    }
    return {};
}

std::optional<GridPlacement> placeOnGrid(const glm::dmat4& voxelFromWorld, const ImagePlane& plane,
                                         int columns, int rows) {
    const glm::dvec3 first = transformPoint(voxelFromWorld, plane.positionMm);
    const glm::dvec3 column = transformVector(voxelFromWorld, plane.columnSpacingMm * plane.rowDirection);
    const glm::dvec3 row = transformVector(voxelFromWorld, plane.rowSpacingMm * plane.columnDirection);
    // This is false for NaN too.
    const auto isWithin = [](double x) { return std::abs(x) <= kFarthest; };
    if (!isWithin(first.x) || !isWithin(first.y) || !isWithin(first.z)) return {};
    const auto columnStep = unitStep(column);
    const auto rowStep = unitStep(row);
    if (!columnStep || !rowStep) return {};
    if (glm::abs(*columnStep) == glm::abs(*rowStep)) return {};
    const GridPlacement placement{glm::ivec3(glm::round(first)), *columnStep, *rowStep};
    for (const double c : {0.0, columns - 1.0}) {
        for (const double r : {0.0, rows - 1.0}) {
            const glm::dvec3 voxel = glm::dvec3(placement.origin) + c * glm::dvec3(placement.columnStep) +
                                     r * glm::dvec3(placement.rowStep);
            if (!isNear(first + c * column + r * row, voxel)) return {};
        }
    }
    return placement;
}

}  // namespace macula::dicom
