#include "pipeline/volume/medium.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "pipeline/volume/range_max.h"

namespace macula {

namespace {

// Interpolating two entries in floating point can come out a few parts in 10^7 above both.
constexpr float kOutward = 1.0f + 1e-6f;
constexpr int kMaxReach = 255;

double linearFromSrgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

// Chebyshev distance of each empty brick to the nearest occupied one, in place: 0 becomes a positive
// distance. Two sweeps over the 26 neighbours are exact for this metric (Rosenfeld and Pfaltz 1966). Outside
// the grid is empty.
std::vector<int> distanceToOccupied(const BrickGrid& grid, const std::vector<float>& bounds) {
    const glm::ivec3 size = grid.size;
    std::vector<int> distance(bounds.size());
    for (std::size_t i = 0; i < bounds.size(); ++i) distance[i] = bounds[i] > 0.0f ? 0 : kMaxReach;
    const auto relax = [&](int x, int y, int z, int direction) {
        int& here = distance[grid.index(x, y, z)];
        for (int dz = -1; dz <= 1; ++dz) {
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dx = -1; dx <= 1; ++dx) {
                    if ((dz * 9 + dy * 3 + dx) * direction >= 0) continue;  // not yet swept
                    const glm::ivec3 n{x + dx, y + dy, z + dz};
                    if (n.x < 0 || n.y < 0 || n.z < 0 || n.x >= size.x || n.y >= size.y || n.z >= size.z)
                        continue;
                    here = std::min(here, distance[grid.index(n.x, n.y, n.z)] + 1);
                }
            }
        }
    };
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) relax(x, y, z, 1);
        }
    }
    for (int z = size.z - 1; z >= 0; --z) {
        for (int y = size.y - 1; y >= 0; --y) {
            for (int x = size.x - 1; x >= 0; --x) relax(x, y, z, -1);
        }
    }
    return distance;
}

// A voxel more than the brick on all sides, so that rounding in the shaders cannot look into it.
Box roomOf(int x, int y, int z) {
    const glm::dvec3 low = double(kBrickVoxels) * glm::dvec3(x, y, z) - 1.5;
    return {low, low + double(kBrickVoxels) + 2.0};
}

void emptyRemoved(Medium& medium, const BrickGrid& grid, const Volume& volume, const Clip& clip) {
    if (clip.isNothing() || clip.removedCastsShadow) return;
    parallelFor(std::size_t(grid.size.z), [&](std::size_t layer) {
        const int z = static_cast<int>(layer);
        for (int y = 0; y < grid.size.y; ++y) {
            for (int x = 0; x < grid.size.x; ++x) {
                float& bound = medium.bounds[grid.index(x, y, z)];
                if (bound > 0.0f && removesAll(clip, volume.worldFromVoxel(), roomOf(x, y, z))) bound = 0.0f;
            }
        }
    });
}

}  // namespace

std::size_t Medium::visibleBricks() const {
    return static_cast<std::size_t>(
        std::count_if(bounds.begin(), bounds.end(), [](float b) { return b > 0.0f; }));
}

Medium makeMedium(const Volume& volume, const BrickGrid& grid, const TransferFunction& function,
                  const Clip& clip) {
    MACULA_CHECK(!usesGradientOpacity(function));
    const EntryMap map = entryMapOf(volume);
    const UnitsFromStored units = volume.unitsFromStored();

    Medium medium;
    medium.anisotropy = static_cast<float>(function.anisotropy);
    medium.extinctionPerMm.resize(map.tableSize());
    medium.albedo.resize(map.tableSize());
    for (std::size_t entry = 0; entry + 1 < map.tableSize(); ++entry) {
        const double value = units(double(map.low) + double(entry));
        const glm::dvec3 colour = colourAt(function, value);
        medium.extinctionPerMm[entry] = static_cast<float>(extinctionPerMm(function, value));
        medium.albedo[entry] =
            glm::vec4(function.albedo * linearFromSrgb(colour.r), function.albedo * linearFromSrgb(colour.g),
                      function.albedo * linearFromSrgb(colour.b), 0.0);
    }
    medium.extinctionPerMm.back() = medium.extinctionPerMm[map.tableSize() - 2];
    medium.albedo.back() = medium.albedo[map.tableSize() - 2];

    const RangeMax largest(medium.extinctionPerMm);
    medium.gridSize = grid.size;
    medium.bounds.resize(grid.ranges.size());
    for (std::size_t brick = 0; brick < grid.ranges.size(); ++brick) {
        medium.bounds[brick] = largest(grid.ranges[brick].low, grid.ranges[brick].high) * kOutward;
    }
    emptyRemoved(medium, grid, volume, clip);
    const std::vector<int> distance = distanceToOccupied(grid, medium.bounds);
    for (std::size_t brick = 0; brick < medium.bounds.size(); ++brick) {
        if (distance[brick] > 0) medium.bounds[brick] = -static_cast<float>(distance[brick]);
    }
    return medium;
}

}  // namespace macula
