#include "dicom/segmentation/grid_placement.h"

#include <cmath>
#include <cstdlib>

namespace macula::dicom {

namespace {

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
