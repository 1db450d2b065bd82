#include "study/open/slice_images.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace macula::study {

namespace {

constexpr double kToleranceSlices = 0.1;

bool isInterpolated(const Volume& volume, int slice) {
    return std::ranges::any_of(volume.provenance().interpolatedSlices, [slice](const SliceRange& range) {
        return slice >= range.first && slice <= range.last;
    });
}

}  // namespace

std::vector<SliceImage> imagesOfSlices(const Volume& volume, const dicom::Stack& stack) {
    const glm::dmat4& world = volume.worldFromVoxel();
    const glm::dvec3 normal = glm::normalize(glm::cross(glm::dvec3(world[0]), glm::dvec3(world[1])));
    const double stepMm = glm::dot(glm::dvec3(world[2]), normal);
    const std::vector<glm::dvec3> positionsMm = dicom::slicePositionsMm(stack);
    const int count = volume.size().z;
    const bool isWhole = positionsMm.size() == std::size_t(count);
    // How many slices of the stack lie before the first one of the volume.
    const double offset = isWhole || positionsMm.empty()
                              ? 0.0
                              : glm::dot(glm::dvec3(world[3]) - positionsMm.front(), normal) / stepMm;
    std::vector<SliceImage> images;
    for (int k = 0; k < count; ++k) {
        SliceImage image{.positionMm = glm::dvec3(world * glm::dvec4(0.0, 0.0, double(k), 1.0)), .frame = {}};
        const double at = std::round(double(k) + offset);
        if (at >= 0.0 && at < double(positionsMm.size())) {
            const auto j = std::size_t(at);
            const bool isThere = isWhole || std::abs(glm::dot(positionsMm[j] - image.positionMm, normal)) <=
                                                kToleranceSlices * std::abs(stepMm);
            const dicom::SliceSource& source = stack.slices[j];
            if (isThere) image.positionMm = positionsMm[j];
            if (isThere && !source.interpolated() && !isInterpolated(volume, k))
                image.frame = &stack.frames.at(source.below);
        }
        images.push_back(image);
    }
    return images;
}

}  // namespace macula::study
