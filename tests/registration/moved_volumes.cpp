#include "moved_volumes.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <utility>
#include <vector>

#include "base/parallel.h"

namespace macula::registration::test {

glm::dmat4 rigid(double degrees, const glm::dvec3& shiftMm) {
    const double radians = degrees * std::numbers::pi / 180.0;
    return glm::rotate(glm::translate(glm::dmat4(1.0), shiftMm), radians,
                       glm::normalize(glm::dvec3(1.0, -0.6, 2.0)));
}

Scan straightScan(double leansDeg) {
    Scan scan;
    const glm::dvec3 sidesMm(4.6, 4.1, 5.5);
    const double lean = std::tan(leansDeg * std::numbers::pi / 180.0);
    const glm::dvec3 upward(0.0, lean * sidesMm.z, sidesMm.z);
    const glm::dvec3 middle = 0.5 * glm::dvec3(scan.size - 1);
    scan.worldFromVoxel = affine({sidesMm.x, 0.0, 0.0}, {0.0, sidesMm.y, 0.0}, upward,
                                 -(glm::dvec3(sidesMm.x, 0.0, 0.0) * middle.x +
                                   glm::dvec3(0.0, sidesMm.y, 0.0) * middle.y + upward * middle.z));
    return scan;
}

std::shared_ptr<const Volume> scanOf(const Scan& scan, const glm::dmat4& movedFromPhantom) {
    const glm::dmat4 phantomFromVoxel = glm::inverse(movedFromPhantom) * scan.worldFromVoxel;
    const glm::ivec3 size = scan.size;
    std::vector<float> voxels(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    parallelFor(std::size_t(size.z), [&](std::size_t k) {
        std::size_t at = k * std::size_t(size.x) * std::size_t(size.y);
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i, ++at)
                voxels[at] = static_cast<float>(scan.scanner(
                    phantom::valueHu(transformPoint(phantomFromVoxel, glm::dvec3(i, j, double(k))))));
    });
    auto volume = Volume::createFloat(
        {.size = size, .worldFromVoxel = scan.worldFromVoxel, .unit = scan.unit, .modality = "OT"},
        std::move(voxels));
    return std::make_shared<const Volume>(*std::move(volume));
}

double errorMm(const glm::dmat4& found, const glm::dmat4& truth) {
    double error = 0.0;
    for (const double x : {-120.0, 120.0})
        for (const double y : {-80.0, 80.0})
            for (const double z : {-120.0, 120.0}) {
                const glm::dvec3 p(x, y, z);
                error = std::max(error, glm::length(transformPoint(found, p) - transformPoint(truth, p)));
            }
    return error;
}

}  // namespace macula::registration::test
