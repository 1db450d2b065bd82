#include "made_volumes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace macula::slices::test {

std::vector<Pose> poses() {
    const double tilt = 0.25;
    const glm::dvec3 origin{-103.7, 55.3, -1012.9};
    const glm::dmat3 turned = [] {
        const glm::dvec3 x = glm::normalize(glm::dvec3(0.8, 0.5, -0.2));
        const glm::dvec3 y = glm::normalize(glm::cross(glm::dvec3(0.1, -0.3, 0.9), x));
        return glm::dmat3(x, y, glm::cross(x, y));
    }();
    return {{"axial", affine({0.7, 0, 0}, {0, 0.7, 0}, {0, 0, 1.25}, origin)},
            {"axial, from head to feet", affine({0.7, 0, 0}, {0, 0.7, 0}, {0, 0, -1.25}, origin)},
            {"prone", affine({-0.7, 0, 0}, {0, -0.7, 0}, {0, 0, 2.5}, origin)},
            {"coronal", affine({1.1, 0, 0}, {0, 0, -1.1}, {0, 3.0, 0}, origin)},
            {"sagittal", affine({0, 0.9, 0}, {0, 0, -0.9}, {-4.8, 0, 0}, origin)},
            {"tilted gantry",
             affine({0.5, 0, 0}, {0, 0.5 * std::cos(tilt), -0.5 * std::sin(tilt)}, {0, 0, 2.0}, origin)},
            {"oblique", affine(0.8 * turned[0], 1.3 * turned[1], 2.1 * turned[2], origin)},
            {"oblique, left-handed", affine(0.8 * turned[0], 1.3 * turned[1], -2.1 * turned[2], origin)},
            {"sheared", affine({0.9, 0.1, 0.2}, {-0.3, 1.2, 0.1}, {0.4, -0.5, 1.7}, origin)}};
}

namespace {

VolumeOptions optionsOf(const glm::ivec3& size, const glm::dmat4& worldFromVoxel) {
    return {.size = size,
            .worldFromVoxel = worldFromVoxel,
            .unitsFromStored = {},
            .unit = Unit::hounsfield,
            .modality = "CT",
            .padding = {},
            .provenance = {}};
}

std::size_t countOf(const glm::ivec3& size) {
    return std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
}

glm::dvec3 voxelFromWorld(const Volume& volume, const glm::dvec3& mm) {
    return transformPoint(glm::inverse(volume.worldFromVoxel()), mm);
}

}  // namespace

Volume storedVolume(const glm::ivec3& size, const glm::dmat4& worldFromVoxel, Padding padding) {
    VolumeOptions options = optionsOf(size, worldFromVoxel);
    options.unitsFromStored = {.slope = 1.5, .intercept = -1024.0};
    if (padding == Padding::some) options.padding = StoredRange{3, 23};
    Random random(11);
    std::vector<std::uint16_t> voxels(countOf(size));
    for (std::uint16_t& voxel : voxels) {
        const bool isOut = padding == Padding::some && random() % 5 == 0;
        voxel = static_cast<std::uint16_t>(isOut ? 3 + random() % 21 : 24 + random() % 4000);
    }
    return Volume::create(std::move(options), std::move(voxels)).value();
}

Volume floatVolume(const glm::ivec3& size, const glm::dmat4& worldFromVoxel, Padding padding) {
    VolumeOptions options = optionsOf(size, worldFromVoxel);
    constexpr float kPadding = -5000.0F;
    if (padding == Padding::some) options.floatPadding = kPadding;
    Random random(12);
    std::vector<float> voxels(countOf(size));
    for (float& voxel : voxels) {
        voxel = static_cast<float>(uniform(random, -1000.0, 3000.0));
        if (padding == Padding::none || random() % 5 != 0) continue;
        voxel = random() % 2 == 0 ? kPadding : std::numeric_limits<float>::quiet_NaN();
    }
    return Volume::createFloat(std::move(options), std::move(voxels)).value();
}

Volume volumeOf(const glm::ivec3& size, const glm::dmat4& worldFromVoxel, std::vector<float> values) {
    return Volume::createFloat(optionsOf(size, worldFromVoxel), std::move(values)).value();
}

glm::dvec3 middleMm(const Volume& volume) {
    return transformPoint(volume.worldFromVoxel(), 0.5 * glm::dvec3(volume.size() - 1));
}

double uniform(Random& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

glm::dvec3 randomPointMm(const Volume& volume, Random& random) {
    glm::dvec3 at(0.0);
    for (int axis = 0; axis < 3; ++axis) at[axis] = uniform(random, 0.0, volume.size()[axis] - 1.0);
    return transformPoint(volume.worldFromVoxel(), at);
}

glm::ivec3 randomVoxel(const Volume& volume, Random& random) {
    glm::ivec3 voxel(0);
    for (int axis = 0; axis < 3; ++axis)
        voxel[axis] = static_cast<int>(random() % static_cast<unsigned>(volume.size()[axis]));
    return voxel;
}

SlicePlane randomPlane(const glm::dvec3& centreMm, Random& random) {
    const auto direction = [&] {
        while (true) {
            const double x = uniform(random, -1.0, 1.0);
            const double y = uniform(random, -1.0, 1.0);
            const glm::dvec3 v{x, y, uniform(random, -1.0, 1.0)};
            const double length = glm::length(v);
            if (length > 0.2 && length < 1.0) return v / length;
        }
    };
    const glm::dvec3 right = direction();
    glm::dvec3 down(0.0);
    while (glm::length(down) < 0.1) down = glm::cross(right, direction());
    return {.centreMm = centreMm, .right = right, .down = glm::normalize(down)};
}

double valueAt(const Volume& volume, const glm::dvec3& mm) {
    const glm::dvec3 at = voxelFromWorld(volume, mm);
    const glm::ivec3 size = volume.size();
    for (int axis = 0; axis < 3; ++axis)
        if (!(at[axis] >= -0.5 && at[axis] <= size[axis] - 0.5)) return std::nan("");
    double sum = 0.0;
    double weights = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        glm::ivec3 voxel(0);
        double weight = 1.0;
        for (int axis = 0; axis < 3; ++axis) {
            const double inside = std::clamp(at[axis], 0.0, size[axis] - 1.0);
            const double below = std::floor(inside);
            const bool isHigh = (corner >> axis & 1) != 0;
            voxel[axis] = std::min(static_cast<int>(below) + (isHigh ? 1 : 0), size[axis] - 1);
            weight *= isHigh ? inside - below : 1.0 - (inside - below);
        }
        if (weight == 0.0 || volume.isPadding(voxel.x, voxel.y, voxel.z)) continue;
        sum += weight * volume.value(voxel.x, voxel.y, voxel.z);
        weights += weight;
    }
    return weights > 0.0 ? sum / weights : std::nan("");
}

bool isAtJump(const Volume& volume, const glm::dvec3& mm) {
    const glm::dvec3 at = voxelFromWorld(volume, mm);
    for (int axis = 0; axis < 3; ++axis) {
        const double halves = 2.0 * at[axis];
        if (std::abs(halves - std::round(halves)) < 1e-4) return true;
    }
    return false;
}

}  // namespace macula::slices::test
