#include "pipeline/volume/medium.h"

#include <algorithm>
#include <limits>

#include "base/check.h"
#include "base/parallel.h"
#include "base/srgb.h"
#include "pipeline/volume/clip_bricks.h"
#include "pipeline/volume/empty_space.h"
#include "pipeline/volume/range_max.h"
#include "pipeline/volume/voxel_blocks.h"

namespace macula {

namespace {

// Interpolating two entries in floating point can come out a few parts in 10^7 above both.
constexpr float kOutward = 1.0f + 1e-6f;
constexpr int kGradientSteps = 4096;

// Calls body(x, y, z) for every brick, with rows on all cores.
template <class Body>
void forEachBrick(glm::ivec3 size, const Body& body) {
    parallelFor(std::size_t(size.y) * std::size_t(size.z), [&](std::size_t row) {
        const int y = static_cast<int>(row) % size.y;
        const int z = static_cast<int>(row) / size.y;
        for (int x = 0; x < size.x; ++x) body(x, y, z);
    });
}

// The majorant of two media that share a brick. If one has none there, it is exactly that of the other, so
// that ownBounds() can separate them again.
float sumOfBounds(float first, float second) {
    if (!(second > 0.0f)) return first;
    return first > 0.0f ? (first + second) * kOutward : second;
}

// Computes the majorants of bricks from the extinction by entry.
void boundBricks(Medium& medium, const Volume& volume, const BrickGrid& grid, const Clip& clip,
                 const MaskBits* mask) {
    const RangeMax largest(medium.mostPerMm());
    medium.gridSize = grid.size;
    medium.bounds.resize(grid.ranges.size());
    forEachBrick(grid.size, [&](int x, int y, int z) {
        const std::size_t brick = grid.index(x, y, z);
        medium.bounds[brick] = largest(grid.ranges[brick].low, grid.ranges[brick].high) * kOutward;
        if (!medium.addedBounds.empty())
            medium.bounds[brick] = sumOfBounds(medium.bounds[brick], medium.addedBounds[brick]);
    });
    emptyRemovedBricks(clip, volume, grid, medium.bounds);
    if (mask != nullptr && !clip.removedCastsShadow) emptyMaskedBricks(*mask, grid, medium.bounds);
    measureEmptySpace(grid.size, medium.bounds);
}

// A third of the width of the narrowest piece, but at least one stored value, the resolution of the tables.
double featureOf(const TransferFunction& function, double leastUnits) {
    double narrowest = std::numeric_limits<double>::infinity();
    const auto look = [&](const auto& points) {
        for (std::size_t i = 1; i < points.size(); ++i) {
            const double width =
                (points[i].value - points[i - 1].value) * (1.0 - 0.9 * points[i - 1].sharpness);
            if (width > 0.0) narrowest = std::min(narrowest, width);
        }
    };
    look(function.opacity);
    look(function.colour);
    look(function.steep.opacity);
    look(function.steep.colour);
    return std::max(narrowest / 3.0, leastUnits);
}

// The preset's gradients are per voxel of mean edge, as in VTK (docs/presets.md).
void tabulateGradientOpacity(const TransferFunction& function, const Volume& volume, Medium& medium) {
    const glm::dvec3 spacing = volume.spacingMm();
    const double voxelMm = (spacing.x + spacing.y + spacing.z) / 3.0;
    // The table ends at the curve's last point, beyond which the curve is constant. A curve whose last point
    // is at 0 is constant everywhere.
    const double last = std::max(function.gradientOpacity.back().value, 1e-6);
    medium.gradientOpacity.resize(kGradientSteps + 1);
    for (int step = 0; step <= kGradientSteps; ++step) {
        medium.gradientOpacity[std::size_t(step)] =
            static_cast<float>(gradientOpacityAt(function, last * step / kGradientSteps));
    }
    medium.gradientStep = last / kGradientSteps / voxelMm;
    if (function.density > 0.0) medium.unitDepthMm = function.unitDistanceMm / function.density;
}

}  // namespace

std::vector<float> Medium::mostPerMm() const {
    std::vector<float> most = extinctionPerMm;
    for (std::size_t entry = 0; entry < steep.size(); ++entry)
        most[entry] = std::max(most[entry], steep[entry].w);
    return most;
}

std::size_t Medium::visibleBricks() const {
    return static_cast<std::size_t>(
        std::count_if(bounds.begin(), bounds.end(), [](float b) { return b > 0.0f; }));
}

std::vector<float> Medium::ownBounds() const {
    std::vector<float> own = bounds;
    for (std::size_t brick = 0; brick < addedBounds.size(); ++brick)
        if (!(own[brick] > addedBounds[brick])) own[brick] = 0.0f;
    return own;
}

double featureUnitsOf(const TransferFunction& function, const Volume& volume) {
    return featureOf(function, volume.unitsFromStored().slope);
}

std::vector<glm::vec4> opticsByEntry(const Volume& volume, const TransferFunction& function) {
    const EntryMap map = entryMapOf(volume);
    const UnitsFromStored units = volume.unitsFromStored();
    std::vector<glm::vec4> optics(map.tableSize());
    for (std::size_t entry = 0; entry + 1 < map.tableSize(); ++entry) {
        const double value = units(double(map.low) + double(entry));
        const glm::dvec3 colour = colourAt(function, value);
        optics[entry] = glm::vec4(
            function.albedo * decodedSrgb(colour.r), function.albedo * decodedSrgb(colour.g),
            function.albedo * decodedSrgb(colour.b), static_cast<float>(extinctionPerMm(function, value)));
    }
    optics.back() = optics[map.tableSize() - 2];
    return optics;
}

Medium makeMedium(const Volume& volume, const BrickGrid& grid, const TransferFunction& function,
                  const Clip& clip, const MaskBits* mask, std::span<const float> added) {
    MACULA_CHECK(added.empty() || added.size() == grid.ranges.size());
    Medium medium;
    medium.anisotropy = static_cast<float>(function.anisotropy);
    medium.surface = function.surface;
    if (medium.surface.weight > 0.0) medium.coat = coatOf(medium.surface);
    medium.ambient = static_cast<float>(function.lighting.ambient);
    medium.diffuse = static_cast<float>(function.lighting.diffuse);
    medium.featureUnits = featureUnitsOf(function, volume);
    if (usesGradientOpacity(function)) tabulateGradientOpacity(function, volume, medium);
    medium.albedo = opticsByEntry(volume, function);
    medium.extinctionPerMm.resize(medium.albedo.size());
    for (std::size_t entry = 0; entry < medium.albedo.size(); ++entry)
        medium.extinctionPerMm[entry] = medium.albedo[entry].w;
    if (usesSteepCurves(function)) {
        medium.steep = opticsByEntry(volume, withCurvesSwapped(function));
        medium.steepGradientPerMm = function.steep.gradientPerMm;
    }
    medium.addedBounds.assign(added.begin(), added.end());
    boundBricks(medium, volume, grid, clip, mask);
    return medium;
}

Medium makeMedium(const Volume& volume, const BrickGrid& grid, Projection projection, const Clip& clip,
                  const MaskBits* mask) {
    const EntryMap map = entryMapOf(volume);
    const std::size_t count = map.tableSize();
    Medium medium;
    medium.albedo.resize(count, glm::vec4(1.0f));
    medium.extinctionPerMm.resize(count, 1.0f);
    for (std::size_t entry = 0; entry < count; ++entry) {
        switch (projection) {
            case Projection::maximum:
                medium.extinctionPerMm[entry] = static_cast<float>(entry + 1);
                break;
            case Projection::minimum:
                medium.extinctionPerMm[entry] = static_cast<float>(count - entry);
                break;
            case Projection::mean:
                break;
        }
    }
    if (map.padding) medium.extinctionPerMm[std::size_t(map.air - map.low)] = 0.0f;
    boundBricks(medium, volume, grid, clip, mask);
    return medium;
}

void coverCoarseBlocks(Medium& medium, const BrickGrid& grid, std::span<const std::uint8_t> levels) {
    MACULA_CHECK_EQ(levels.size(), grid.blockRanges.size());
    const RangeMax largest(medium.mostPerMm());
    forEachBrick(grid.size, [&](int x, int y, int z) {
        float& bound = medium.bounds[grid.index(x, y, z)];
        if (!(bound > 0.0f)) return;
        EntryRange range = grid.ranges[grid.index(x, y, z)];
        const glm::ivec3 low = grid.firstBlockOf({x, y, z});
        const glm::ivec3 high = grid.lastBlockOf({x, y, z});
        for (int k = low.z; k <= high.z; ++k) {
            for (int j = low.y; j <= high.y; ++j) {
                for (int i = low.x; i <= high.x; ++i) {
                    const std::size_t block = grid.blockIndex(i, j, k);
                    if (levels[block] == 0 || levels[block] == kAbsent) continue;
                    range.low = std::min(range.low, grid.blockRanges[block].low);
                    range.high = std::max(range.high, grid.blockRanges[block].high);
                }
            }
        }
        bound = largest(range.low, range.high) * kOutward;
        if (!medium.addedBounds.empty()) bound = sumOfBounds(bound, medium.addedBounds[grid.index(x, y, z)]);
    });
}

}  // namespace macula
