#include "pipeline/volume/visible_hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <random>

#include "pipeline/volume/entry_map.h"
#include "trace/scenes.h"

namespace macula {
namespace {

using Places = std::vector<glm::dvec3>;

TransferFunction ramp() {
    TransferFunction f;
    f.name = "ramp";
    f.colour = {{0, {1, 1, 1}}};
    f.opacity = {{100, 0.0}, {400, 1.0}};
    return f;
}

// What is left of the volume, and what is beside it.
struct Parts {
    Clip clip = {};
    std::optional<MaskBits> mask = {};
    Additions additions = {};

    const MaskBits* bits() const { return mask ? &*mask : nullptr; }
    bool show(const Volume& volume, const glm::dvec3& voxel) const {
        const glm::ivec3 nearest(glm::round(voxel));
        return (!mask || mask->shows(nearest.x, nearest.y, nearest.z)) &&
               shows(clip, transformPoint(volume.worldFromVoxel(), voxel));
    }
};

// From central differences of values; beyond the outer voxels they go on.
double steepPartOf(const Volume& volume, const Medium& medium, const glm::dvec3& voxel) {
    glm::dvec3 perVoxel;
    for (int axis = 0; axis < 3; ++axis) {
        glm::ivec3 low(voxel);
        glm::ivec3 high(voxel);
        low[axis] = std::max(low[axis] - 1, 0);
        high[axis] = std::min(high[axis] + 1, volume.size()[axis] - 1);
        perVoxel[axis] = (volume.value(high.x, high.y, high.z) - volume.value(low.x, low.y, low.z)) / 2.0;
    }
    const glm::dmat3 mmFromVoxel(volume.worldFromVoxel());
    const double ratio =
        glm::length(glm::inverse(glm::transpose(mmFromVoxel)) * perVoxel) / medium.steepGradientPerMm;
    return ratio * ratio / (1.0 + ratio * ratio);
}

// Every row along every axis, voxel by voxel, in double precision: nothing is skipped, all ends are kept.
Places allEndsMm(const Volume& volume, const Medium& medium, const Parts& parts) {
    const EntryMap map = entryMapOf(volume);
    const double leastPerMm = 0.1 / volume.worldBox().diagonal();
    const glm::ivec3 size = volume.size();
    std::optional<SecondExtinction> second;
    if (parts.additions.second) second.emplace(*parts.additions.second, volume);
    const auto ownAt = [&](const glm::dvec3& voxel) {
        const glm::ivec3 low = glm::ivec3(glm::floor(voxel));
        double entry = 0.0;
        for (int corner = 0; corner < 8; ++corner) {
            const glm::ivec3 offset(corner & 1, (corner >> 1) & 1, corner >> 2);
            const glm::dvec3 f = voxel - glm::dvec3(low);
            const double weight =
                (offset.x ? f.x : 1 - f.x) * (offset.y ? f.y : 1 - f.y) * (offset.z ? f.z : 1 - f.z);
            if (weight == 0.0) continue;
            const glm::ivec3 at = low + offset;
            entry += weight * double(map.entryOf(volume.stored(at.x, at.y, at.z)));
        }
        const auto first = std::size_t(entry);
        const double part = entry - double(first);
        const auto by = [&](const auto& extinctionOf) {
            return double(extinctionOf(first)) * (1.0 - part) +
                   (part > 0.0 ? double(extinctionOf(first + 1)) * part : 0.0);
        };
        const double flat = by([&](std::size_t n) { return medium.extinctionPerMm[n]; });
        if (medium.steep.empty()) return flat;
        // Linear along an axis, as rows go.
        const glm::dvec3 below = glm::floor(voxel);
        const glm::dvec3 above = glm::ceil(voxel);
        const double steep = std::lerp(steepPartOf(volume, medium, below), steepPartOf(volume, medium, above),
                                       glm::dot(voxel - below, glm::dvec3(1.0)));
        return std::lerp(flat, by([&](std::size_t n) { return medium.steep[n].w; }), steep);
    };
    const auto extinctionAt = [&](const glm::dvec3& voxel) {
        return parts.show(volume, voxel) ? ownAt(voxel) + (second ? second->at(voxel) : 0.0) : 0.0;
    };
    Places places;
    for (int axis = 0; axis < 3; ++axis) {
        const double stepMm = glm::length(glm::dvec3(volume.worldFromVoxel()[axis]));
        for (int a = 0; a < size[(axis + 1) % 3]; ++a)
            for (int b = 0; b < size[(axis + 2) % 3]; ++b)
                for (const int step : {1, -1}) {
                    glm::dvec3 voxel(0.0);
                    voxel[(axis + 1) % 3] = a;
                    voxel[(axis + 2) % 3] = b;
                    double depth = 0.0;
                    int begin = -1;
                    for (int i = step > 0 ? 0 : size[axis] - 1; i >= 0 && i < size[axis]; i += step) {
                        voxel[axis] = i;
                        const double extinction = extinctionAt(voxel);
                        if (extinction < leastPerMm) {
                            begin = -1;
                            depth = 0.0;
                            continue;
                        }
                        if (begin < 0) begin = i;
                        depth += extinction * stepMm;
                        if (depth < 0.1) continue;
                        double seen = begin - 0.5 * step;
                        if (begin - step >= 0 && begin - step < size[axis]) {
                            double hidden = begin - step;
                            seen = begin;
                            for (int n = 0; n < 50; ++n) {
                                voxel[axis] = 0.5 * (hidden + seen);
                                (extinctionAt(voxel) >= leastPerMm ? seen : hidden) = voxel[axis];
                            }
                        }
                        voxel[axis] = seen;
                        places.push_back(transformPoint(volume.worldFromVoxel(), voxel));
                        break;
                    }
                }
    }
    return places;
}

double reach(const Places& places, const glm::dvec3& direction) {
    double most = -std::numeric_limits<double>::infinity();
    for (const glm::dvec3& place : places) most = std::max(most, glm::dot(place, direction));
    return most;
}

void expectSameHull(const Volume& volume, const TransferFunction& function, const Parts& parts = {}) {
    const BrickGrid grid = makeBrickGrid(volume);
    const Medium medium = makeMedium(volume, grid, function, parts.clip, parts.bits(),
                                     addedBounds(parts.additions, volume, grid));
    const Places all = allEndsMm(volume, medium, parts);
    const Places hull = visibleHullMm(volume, grid, medium, parts.clip, parts.bits(), parts.additions);
    ASSERT_EQ(hull.empty(), all.empty());
    EXPECT_LE(hull.size(), 2 * all.size());
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 300 && !all.empty(); ++i) {
        const glm::dvec3 direction =
            glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
        EXPECT_NEAR(reach(hull, direction), reach(all, direction), 0.005);
    }
}

Volume volumeOf(const glm::ivec3& size, const glm::dmat4& worldFromVoxel, std::vector<std::uint16_t> values) {
    auto volume = Volume::create(
        {.size = size, .worldFromVoxel = worldFromVoxel, .unit = Unit::hounsfield, .modality = "CT"},
        std::move(values));
    EXPECT_TRUE(volume.ok()) << volume.error().message;
    return *std::move(volume);
}

std::size_t voxelsOf(const glm::ivec3& size) {
    return std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
}

// Sparse points, blobs with holes, thin plates: what lies inside of the hull of the rows along x is not
// looked for, what reaches out of it is.
TEST(VisibleHull, IsThatOfEveryRowOfEveryAxis) {
    std::mt19937 random(11);
    const glm::dmat4 oblique(glm::dvec4(0.8, 0.3, 0.0, 0.0), glm::dvec4(-0.2, 0.9, 0.1, 0.0),
                             glm::dvec4(0.1, -0.3, 1.7, 0.0), glm::dvec4(-30, 12, 900, 1));
    for (const glm::ivec3 size : {glm::ivec3(17, 13, 11), glm::ivec3(40, 9, 21), glm::ivec3(5, 33, 2)}) {
        for (const double share : {0.004, 0.05, 0.6}) {
            std::vector<std::uint16_t> values(voxelsOf(size));
            for (std::uint16_t& value : values)
                value = std::uint16_t(std::uniform_real_distribution<double>(0, 1)(random) < share
                                          ? std::uniform_int_distribution<int>(120, 3000)(random)
                                          : std::uniform_int_distribution<int>(0, 99)(random));
            expectSameHull(volumeOf(size, oblique, std::move(values)), ramp());
        }
    }
}

// What is hidden leaves holes in rows, and the second volume fills some of them.
TEST(VisibleHull, WithAMaskAClipAndASecondVolumeIsThatOfEveryRowToo) {
    std::mt19937 random(5);
    const glm::ivec3 size(23, 18, 20);
    const auto scattered = [&](double share, const glm::dmat4& worldFromVoxel) {
        std::vector<std::uint16_t> values(voxelsOf(size));
        for (std::uint16_t& value : values)
            value = std::uniform_real_distribution<double>(0, 1)(random) < share ? 2500 : 50;
        return volumeOf(size, worldFromVoxel, std::move(values));
    };
    for (const double share : {0.02, 0.4}) {
        const Volume volume = scattered(share, glm::dmat4(1.0));
        Parts parts;
        parts.clip.ball = Ball{.centreMm = {9.0, 8.3, 11.0}, .radiusMm = 8.6};
        expectSameHull(volume, ramp(), parts);
        parts.clip.ofBall = Keep::outside;
        parts.clip.planes = {{.normal = glm::normalize(glm::dvec3(1.0, 0.4, 0.0)), .offsetMm = 3.1}};
        parts.mask = MaskBits{size, std::vector<std::uint32_t>((voxelsOf(size) + 31) / 32)};
        for (std::uint32_t& word : parts.mask->words) word = std::uint32_t(random() | random());
        expectSameHull(volume, ramp(), parts);
        glm::dmat4 moved(1.1);
        moved[3] = {-2.4, 3.7, 1.2, 1.0};
        parts.additions.second.emplace();
        parts.additions.second->volume = std::make_shared<const Volume>(scattered(0.03, moved));
        parts.additions.second->function = std::make_shared<const TransferFunction>(ramp());
        expectSameHull(volume, ramp(), parts);
        parts.clip = {};
        parts.mask.reset();
        expectSameHull(volume, ramp(), parts);
    }
}

// Flat matter alone, steep matter alone, and matter that is seen less where it is steep.
TEST(VisibleHull, OfSteepMatterIsThatOfEveryRowToo) {
    std::mt19937 random(17);
    const glm::ivec3 size(21, 17, 14);
    const glm::dmat4 oblique(glm::dvec4(0.8, 0.3, 0.0, 0.0), glm::dvec4(-0.2, 0.9, 0.1, 0.0),
                             glm::dvec4(0.1, -0.3, 1.7, 0.0), glm::dvec4(-30, 12, 900, 1));
    for (int trial = 0; trial < 6; ++trial) {
        std::vector<std::uint16_t> values(voxelsOf(size));
        for (std::uint16_t& value : values)
            value = std::uint16_t(random() % 3 == 0 ? random() % 3000 : random() % 130);
        TransferFunction function = ramp();
        function.steep = {.opacity = function.opacity, .colour = function.colour, .gradientPerMm = 400.0};
        for (OpacityPoint& point : trial % 3 == 0 ? function.opacity : function.steep.opacity)
            point.opacity *= trial % 3 == 2 ? 0.05 : 0.0;
        expectSameHull(volumeOf(size, oblique, std::move(values)), function);
    }
}

TEST(VisibleHull, OfABallIsTheBall) {
    const glm::ivec3 size(31, 29, 27);
    std::vector<std::uint16_t> values;
    const glm::dvec3 centre = 0.5 * glm::dvec3(size - 1);
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const double inside = 10.0 - glm::distance(glm::dvec3(x, y, z), centre);
                values.push_back(std::uint16_t(std::clamp(1000.0 + 500.0 * inside, 0.0, 3000.0)));
            }
    const Volume volume = volumeOf(size, glm::dmat4(1.0), values);
    expectSameHull(volume, ramp());
}

TEST(VisibleHull, Extremes) {
    for (const glm::ivec3 size : {glm::ivec3(1), glm::ivec3(1, 1, 40), glm::ivec3(40, 1, 1),
                                  glm::ivec3(1, 40, 1), glm::ivec3(8, 8, 1)}) {
        expectSameHull(volumeOf(size, glm::dmat4(1.0), std::vector<std::uint16_t>(voxelsOf(size), 0)),
                       ramp());
        expectSameHull(volumeOf(size, glm::dmat4(1.0), std::vector<std::uint16_t>(voxelsOf(size), 3000)),
                       ramp());
    }
    // One voxel in each corner, one in the middle.
    const glm::ivec3 size(20, 18, 16);
    for (int corner = 0; corner < 9; ++corner) {
        std::vector<std::uint16_t> values(voxelsOf(size), 0);
        const glm::ivec3 at = corner == 8
                                  ? size / 2
                                  : glm::ivec3(corner & 1 ? size.x - 1 : 0, corner & 2 ? size.y - 1 : 0,
                                               corner & 4 ? size.z - 1 : 0);
        values[std::size_t(at.x) +
               std::size_t(size.x) * (std::size_t(at.y) + std::size_t(size.y) * std::size_t(at.z))] = 3000;
        expectSameHull(volumeOf(size, glm::dmat4(1.0), std::move(values)), ramp());
    }
}

}  // namespace
}  // namespace macula
