#include "pipeline/volume/medium.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "base/phantom.h"
#include "pipeline/volume/range_max.h"
#include "trace/scenes.h"

namespace macula {
namespace {

TEST(RangeMax, IsExactOnEveryInterval) {
    std::mt19937 random(1);
    std::vector<float> values(37);
    for (float& v : values) v = std::uniform_real_distribution<float>(-1, 1)(random);
    const RangeMax largest(values);
    for (std::size_t first = 0; first < values.size(); ++first) {
        for (std::size_t last = first; last < values.size(); ++last) {
            EXPECT_EQ(largest(first, last),
                      *std::max_element(values.begin() + long(first), values.begin() + long(last) + 1));
        }
    }
    EXPECT_EQ(RangeMax(std::vector<float>{4.0f})(0, 0), 4.0f);
}

// Narrow bands anywhere in the range: what a monotone bound would miss.
TransferFunction randomBandPass(std::mt19937& random, double low, double high) {
    TransferFunction f;
    f.name = "random";
    f.colour = {{0, {1, 1, 1}}};
    std::vector<double> values(12);
    for (double& v : values) v = std::uniform_real_distribution<double>(low, high)(random);
    std::sort(values.begin(), values.end());
    for (std::size_t i = 0; i < values.size(); ++i) {
        f.opacity.push_back(
            {values[i], i % 3 == 1 ? std::uniform_real_distribution<double>(0, 1)(random) : 0.0});
    }
    return f;
}

double trilinear(const Volume& volume, const glm::dvec3& voxel) {
    const glm::dvec3 q = glm::clamp(voxel, glm::dvec3(0.0), glm::dvec3(volume.size() - 1));
    const glm::ivec3 low(q);
    const glm::ivec3 high = glm::min(low + 1, volume.size() - 1);
    const glm::dvec3 f = q - glm::dvec3(low);
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 at{corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y,
                            corner & 4 ? high.z : low.z};
        const double weight =
            (corner & 1 ? f.x : 1 - f.x) * (corner & 2 ? f.y : 1 - f.y) * (corner & 4 ? f.z : 1 - f.z);
        sum += weight * volume.stored(at.x, at.y, at.z);
    }
    return sum;
}

TEST(Medium, BoundIsAboveTheExtinctionEverywhereForRandomBandPassCurves) {
    std::mt19937 random(2);
    const auto volume = scenes::volumeOf({37, 26, 19}, glm::dmat4(1.0), [&](int i, int j, int k) {
        return static_cast<std::uint16_t>(500 + 40 * i + 25 * j * (k % 5) + int(random() % 200));
    });
    const BrickGrid grid = makeBrickGrid(*volume);
    const EntryMap map = entryMapOf(*volume);
    double tightest = 0.0;
    for (int curve = 0; curve < 40; ++curve) {
        const Medium medium = makeMedium(*volume, grid, randomBandPass(random, 400, 3500));
        for (int point = 0; point < 5000; ++point) {
            // Faces at integers, as the tracer has them.
            const glm::dvec3 p{std::uniform_real_distribution<double>(0, 37)(random),
                               std::uniform_real_distribution<double>(0, 26)(random),
                               std::uniform_real_distribution<double>(0, 19)(random)};
            const double entry = trilinear(*volume, p - 0.5) - map.low;
            const auto low = static_cast<std::size_t>(entry);
            const double extinction = std::lerp(double(medium.extinctionPerMm[low]),
                                                double(medium.extinctionPerMm[low + 1]), entry - double(low));
            const glm::ivec3 brick = grid.brickAt(p);
            const double bound = std::max(medium.bounds[grid.index(brick.x, brick.y, brick.z)], 0.0f);
            ASSERT_GE(bound, extinction);
            if (bound > 0.0) tightest = std::max(tightest, extinction / bound);
        }
    }
    EXPECT_GT(tightest, 0.99);  // the bound is reached, so it is not merely large
}

// Whatever part of the matter is steep; and one of the two is met by each bound.
TEST(Medium, BoundIsAboveTheExtinctionOfFlatAndOfSteepMatter) {
    std::mt19937 random(5);
    const auto volume = scenes::volumeOf({28, 19, 21}, glm::dmat4(1.0), [&](int i, int j, int k) {
        return static_cast<std::uint16_t>(500 + 40 * i + 25 * j * (k % 5) + int(random() % 200));
    });
    const BrickGrid grid = makeBrickGrid(*volume);
    double largest = 0.0;
    for (int curve = 0; curve < 20; ++curve) {
        TransferFunction function = randomBandPass(random, 400, 3500);
        const TransferFunction steep = randomBandPass(random, 400, 3500);
        function.steep = {.opacity = steep.opacity, .colour = steep.colour, .gradientPerMm = 50.0};
        const Medium medium = makeMedium(*volume, grid, function);
        const Medium flatAlone = makeMedium(*volume, grid, [&] {
            TransferFunction flat = function;
            flat.steep = {};
            return flat;
        }());
        const Medium steepAlone = makeMedium(*volume, grid, [&] {
            TransferFunction swapped = withCurvesSwapped(function);
            swapped.steep = {};
            return swapped;
        }());
        for (std::size_t brick = 0; brick < medium.bounds.size(); ++brick) {
            const float wanted = std::max(std::max(flatAlone.bounds[brick], steepAlone.bounds[brick]), 0.0f);
            EXPECT_EQ(std::max(medium.bounds[brick], 0.0f), wanted) << curve << " " << brick;
        }
        for (std::size_t entry = 0; entry < medium.steep.size(); ++entry) {
            EXPECT_EQ(medium.steep[entry], steepAlone.albedo[entry]);
            EXPECT_EQ(medium.albedo[entry], flatAlone.albedo[entry]);
            largest = std::max(largest, double(medium.mostPerMm()[entry]) - medium.extinctionPerMm[entry]);
        }
        EXPECT_TRUE(flatAlone.steep.empty());
        EXPECT_EQ(medium.steepGradientPerMm, 50.0);
    }
    EXPECT_GT(largest, 0.0);
}

TEST(Medium, EmptyBricksKnowHowFarTheNearestMatterIs) {
    const auto volume = scenes::volumeOf({80, 80, 80}, glm::dmat4(1.0), [](int i, int j, int k) {
        return static_cast<std::uint16_t>(i == 12 && j == 20 && k == 75 ? 1 : 0);
    });
    const BrickGrid grid = makeBrickGrid(*volume);
    const Medium medium = makeMedium(*volume, grid, scenes::homogeneous(1.0));
    EXPECT_EQ(medium.visibleBricks(), 1u);
    for (int z = 0; z < 10; ++z) {
        for (int y = 0; y < 10; ++y) {
            for (int x = 0; x < 10; ++x) {
                const int distance = std::max({std::abs(x - 1), std::abs(y - 2), std::abs(z - 9)});
                const float bound = medium.bounds[grid.index(x, y, z)];
                if (distance == 0) {
                    EXPECT_GT(bound, 0.0f);
                } else {
                    EXPECT_EQ(bound, -float(distance));
                }
            }
        }
    }
}

TEST(Medium, AVolumeWithNothingVisibleHasNoBricks) {
    const auto volume = scenes::volumeOf({1, 1, 1}, glm::dmat4(1.0), [](int, int, int) { return 0; });
    const Medium medium = makeMedium(*volume, makeBrickGrid(*volume), scenes::homogeneous(1.0));
    EXPECT_EQ(medium.visibleBricks(), 0u);
    ASSERT_EQ(medium.bounds.size(), 1u);
    EXPECT_EQ(medium.bounds[0], -255.0f);
}

// Also where air was measured: the entry of padding is its own.
TEST(Medium, PaddingIsToldFromAir) {
    auto made = Volume::create({.size = {3, 1, 1},
                                .worldFromVoxel = glm::dmat4(1.0),
                                .unitsFromStored = {.slope = 1.0, .intercept = -1024.0},
                                .unit = Unit::hounsfield,
                                .modality = "CT",
                                .padding = StoredRange{9, 9},
                                .provenance = {}},
                               {9, 24, 1100});
    ASSERT_TRUE(made.ok());
    const EntryMap map = entryMapOf(*made);
    EXPECT_EQ(map.entryOf(9), 0);  // -1001 HU
    EXPECT_EQ(map.entryOf(24), 1);
    EXPECT_EQ(map.entryOf(1100), 1077);
}

TEST(Medium, PaddingIsAir) {
    auto made = Volume::create({.size = {2, 1, 1},
                                .worldFromVoxel = glm::dmat4(1.0),
                                .unitsFromStored = {.slope = 1.0, .intercept = -5000.0},
                                .unit = Unit::hounsfield,
                                .modality = "CT",
                                .padding = StoredRange{60000, 60000},
                                .provenance = {}},
                               {60000, 5100});
    ASSERT_TRUE(made.ok());
    const EntryMap map = entryMapOf(*made);
    EXPECT_EQ(map.entryOf(60000), 4000 - map.low);  // -1000 HU
    EXPECT_EQ(map.entryOf(5100), 5100 - map.low);
    std::vector<std::uint16_t> entries(2);
    writeEntries(*made, map, 0, entries);
    EXPECT_EQ(entries[0], map.entryOf(60000));
    const BrickGrid grid = makeBrickGrid(*made);
    EXPECT_EQ(grid.ranges[0].low, 4000 - map.low);
    EXPECT_EQ(grid.ranges[0].high, 5100 - map.low);
}

// Unsigned CT with intercept 0 and padding 0: air has no stored value, and padding must not become water.
TEST(Medium, PaddingIsAirAlsoWhereTheDataCannotHoldAir) {
    auto made = Volume::create({.size = {2, 1, 1},
                                .worldFromVoxel = glm::dmat4(1.0),
                                .unitsFromStored = {.slope = 1.0, .intercept = 0.0},
                                .unit = Unit::hounsfield,
                                .modality = "CT",
                                .padding = StoredRange{0, 0},
                                .provenance = {}},
                               {0, 40});
    ASSERT_TRUE(made.ok());
    const EntryMap map = entryMapOf(*made);
    EXPECT_EQ(map.low, -1000);
    EXPECT_EQ(map.entryOf(0), 0);
    EXPECT_EQ(map.entryOf(40), 1040);
    TransferFunction tissue = scenes::homogeneous(1.0);
    tissue.opacity = {{-200, 0.0}, {-100, 0.5}};
    const Medium medium = makeMedium(*made, makeBrickGrid(*made), tissue);
    EXPECT_EQ(medium.extinctionPerMm[map.entryOf(0)], 0.0f);
    EXPECT_GT(medium.extinctionPerMm[map.entryOf(40)], 0.0f);
}

}  // namespace
}  // namespace macula
