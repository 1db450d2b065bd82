#include "study/planar/localizer_lines.h"

#include <algorithm>
#include <cmath>

#include "base/frames.h"

namespace macula::study {

std::vector<SliceOnLocalizer> slicesOn(const dicom::ImagePlane& localizer, const Volume& volume) {
    const glm::dmat4& worldFromVoxel = volume.worldFromVoxel();
    const glm::dvec3 normal = glm::cross(localizer.rowDirection, localizer.columnDirection);
    const glm::dvec3 ofSlices = glm::cross(glm::dvec3(worldFromVoxel[0]), glm::dvec3(worldFromVoxel[1]));
    constexpr double kAcross = 0.7071067811865476;  // cosine of 45 degrees
    const double cosine =
        std::abs(glm::dot(normal, ofSlices)) / (glm::length(normal) * glm::length(ofSlices));
    // NaN compares as false.
    if (!(cosine <= kAcross) || !(localizer.columnSpacingMm > 0.0) || !(localizer.rowSpacingMm > 0.0))
        return {};
    const auto pixelOf = [&](const glm::dvec3& mm) {
        const glm::dvec3 from = mm - localizer.positionMm;
        return glm::dvec2(glm::dot(from, localizer.rowDirection) / localizer.columnSpacingMm + 0.5,
                          glm::dot(from, localizer.columnDirection) / localizer.rowSpacingMm + 0.5);
    };
    const glm::dvec2 last(volume.size().x - 0.5, volume.size().y - 0.5);
    std::vector<SliceOnLocalizer> slices;
    for (int k = 0; k < volume.size().z; ++k) {
        SliceOnLocalizer slice{.slice = k};
        const std::array<glm::dvec2, 4> corners{glm::dvec2(-0.5), glm::dvec2(last.x, -0.5), last,
                                                glm::dvec2(-0.5, last.y)};
        for (std::size_t c = 0; c < corners.size(); ++c)
            slice.corners[c] = pixelOf(transformPoint(worldFromVoxel, glm::dvec3(corners[c], k)));
        slices.push_back(slice);
    }
    return slices;
}

int sliceNearest(const glm::dvec3& mm, const Volume& volume) {
    const double at = transformPoint(glm::inverse(volume.worldFromVoxel()), mm).z;
    if (!std::isfinite(at)) return 0;
    return int(std::lround(std::clamp(at, 0.0, double(volume.size().z - 1))));
}

}  // namespace macula::study
