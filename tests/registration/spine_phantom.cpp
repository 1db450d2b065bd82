#include "spine_phantom.h"

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace macula::registration::test {

namespace {

constexpr double kAirHu = -1000.0;
constexpr double kLungHu = -850.0;
constexpr double kFatHu = -100.0;
constexpr double kTissueHu = 45.0;
constexpr double kDiscHu = 90.0;
constexpr double kKidneyHu = 180.0;
constexpr double kBoneHu = 260.0;

bool isIn(const glm::dvec3& p, const glm::dvec3& middle, const glm::dvec3& radii) {
    const glm::dvec3 d = (p - middle) / radii;
    return glm::dot(d, d) < 1.0;
}

// Body, disc and spinous process; nothing beside them.
double spineHu(const Trunk& trunk, const glm::dvec3& p, double beside) {
    const double number = std::round(p.z / trunk.vertebraMm);
    const double along = p.z - number * trunk.vertebraMm;
    const double wider = 1.0 + trunk.differsBy * number;
    const double x = p.x / (22.0 * wider);
    const double y = (p.y - 55.0) / (17.0 * wider);
    const bool isBody = std::abs(along) < 0.37 * trunk.vertebraMm;
    if (x * x + y * y < 1.0) return isBody ? kBoneHu * (1.0 + trunk.differsBy * number) : kDiscHu;
    const bool isProcess = std::abs(p.x) < 5.0 && p.y > 72.0 && p.y < 92.0;
    return isProcess && std::abs(along) < 0.25 * trunk.vertebraMm ? kBoneHu : beside;
}

double organHu(const glm::dvec3& p, double beside) {
    if (isIn(p, {-60.0, 40.0, 10.0}, {22.0, 20.0, 45.0})) return kKidneyHu;
    if (isIn(p, {62.0, 42.0, 25.0}, {22.0, 20.0, 45.0})) return kKidneyHu;
    if (isIn(p, {-65.0, -10.0, 190.0}, {55.0, 60.0, 110.0})) return kLungHu;
    if (isIn(p, {65.0, -5.0, 195.0}, {52.0, 58.0, 105.0})) return kLungHu;
    if (isIn(p, {-85.0, 20.0, -130.0}, {22.0, 40.0, 50.0})) return kBoneHu;
    if (isIn(p, {85.0, 20.0, -130.0}, {22.0, 40.0, 50.0})) return kBoneHu;
    return beside;
}

double trunkHu(const Trunk& trunk, const glm::dvec3& p) {
    const double radius = std::hypot(p.x / 150.0, p.y / 105.0);
    if (radius > 1.0) return kAirHu;
    if (radius > 0.88) return kFatHu;
    return spineHu(trunk, p, trunk.hasOrgans ? organHu(p, kTissueHu) : kTissueHu);
}

}  // namespace

std::shared_ptr<const Volume> trunkScan(const Trunk& trunk, double lowMm, double highMm,
                                        const glm::dmat4& patientFromTrunk) {
    constexpr double kSideMm = 4.0;
    const glm::ivec3 size(84, 60, int((highMm - lowMm) / kSideMm));
    const glm::dmat4 trunkFromVoxel =
        affine({kSideMm, 0, 0}, {0, kSideMm, 0}, {0, 0, kSideMm}, {-166.0, -118.0, lowMm + 0.5 * kSideMm});
    std::vector<float> voxels;
    voxels.reserve(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    std::uint32_t noise = trunk.seed;
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) {
                noise = noise * 1664525U + 1013904223U;
                const double share = double(noise >> 8U) / double(1U << 23U) - 1.0;
                voxels.push_back(float(trunkHu(trunk, transformPoint(trunkFromVoxel, glm::dvec3(i, j, k))) +
                                       trunk.noiseHu * share));
            }
    auto made = Volume::createFloat({.size = size,
                                     .worldFromVoxel = patientFromTrunk * trunkFromVoxel,
                                     .unit = Unit::hounsfield,
                                     .modality = "CT"},
                                    std::move(voxels));
    return std::make_shared<const Volume>(*std::move(made));
}

}  // namespace macula::registration::test
