#include "registration/compared_pairs.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include "registration/moved_volumes.h"

namespace macula::registration::test {

namespace {

constexpr double kNoiseHu = 60.0;

glm::dmat4 moved12MmAnd7Degrees() {
    return rigid(7.0, {7.0, -6.0, 7.6});
}

std::shared_ptr<const Volume> fixedPhantom() {
    static const auto made = std::make_shared<const Volume>(phantom::make(coarsePhantom()));
    return made;
}

double uniform(std::uint32_t& state) {
    state = state * 1664525U + 1013904223U;
    return (double(state >> 8U) + 0.5) / double(1U << 24U);
}

std::shared_ptr<const Volume> withNoise(const Volume& volume, std::uint32_t seed) {
    const glm::ivec3 size = volume.size();
    std::vector<float> voxels;
    voxels.reserve(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) {
                // Box and Muller.
                const double radius = std::sqrt(-2.0 * std::log(uniform(seed)));
                const double normal = radius * std::cos(2.0 * std::numbers::pi * uniform(seed));
                voxels.push_back(float(volume.value(i, j, k) + kNoiseHu * normal));
            }
    auto noisy = Volume::createFloat({.size = size,
                                      .worldFromVoxel = volume.worldFromVoxel(),
                                      .unit = volume.unit(),
                                      .modality = volume.modality()},
                                     std::move(voxels));
    return std::make_shared<const Volume>(*std::move(noisy));
}

Scan flatScan() {
    Scan scan;
    const glm::dvec3 sidesMm(2.0, 2.0, 10.0);
    scan.size = {150, 144, 29};
    const glm::dvec3 corner = -0.5 * sidesMm * glm::dvec3(scan.size - 1);
    scan.worldFromVoxel = affine({sidesMm.x, 0, 0}, {0, sidesMm.y, 0}, {0, 0, sidesMm.z}, corner);
    return scan;
}

// Fat is bright, bone and air are dark: no line leads from one to the other.
Scan scanOfAnotherKind() {
    Scan scan = straightScan();
    scan.unit = Unit::raw;
    scan.scanner = [](double hu) {
        if (hu < -500.0) return 20.0;
        if (hu < 0.0) return 900.0;
        return hu < 200.0 ? 400.0 : 120.0;
    };
    return scan;
}

Scan scanOfAPart() {
    Scan scan = straightScan();
    scan.worldFromVoxel[3] += glm::dvec4(glm::dvec3(scan.worldFromVoxel[2]) * double(scan.size.z / 2), 0.0);
    scan.size.z = scan.size.z / 2;
    return scan;
}

}  // namespace

ComparedPair movedPair() {
    const glm::dmat4 truth = moved12MmAnd7Degrees();
    return {"moved by 12 mm and 7 degrees", fixedPhantom(), scanOf(straightScan(), truth), truth};
}

std::vector<ComparedPair> comparedPairs() {
    std::vector<ComparedPair> pairs{movedPair()};
    const glm::dmat4 truth = pairs.front().truth;
    pairs.push_back({"with noise of 60 HU in both", withNoise(*pairs.front().fixed, 7),
                     withNoise(*pairs.front().moving, 77), truth});
    pairs.push_back({"on voxels of 2 x 2 x 10 mm", fixedPhantom(), scanOf(flatScan(), truth), truth});
    pairs.push_back({"another kind of picture", fixedPhantom(), scanOf(scanOfAnotherKind(), truth), truth});
    const glm::dmat4 far = rigid(7.0, {30.0, -20.0, 48.0});
    pairs.push_back({"moved by 60 mm and 7 degrees", fixedPhantom(), scanOf(straightScan(), far), far});
    pairs.push_back({"the upper half of it only", fixedPhantom(), scanOf(scanOfAPart(), truth), truth});
    return pairs;
}

}  // namespace macula::registration::test
