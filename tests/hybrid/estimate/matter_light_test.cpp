// Where light gets to in coarse matter, and what light it must have been.
#include "pipeline/hybrid/estimate/matter_light.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "pipeline/volume/medium.h"
#include "trace/extreme_scenes.h"

namespace macula::hybrid {
namespace {

// Each cell is a voxel.
CoarseMatter cellsOf(const glm::ivec3& size, const std::function<std::uint16_t(int, int, int)>& stored) {
    return CoarseMatter(scenes::volumeOf(size, scenes::grid(glm::dvec3(2.0), size), stored));
}

ShownMatter shownBy(const CoarseMatter& matter, double opacity) {
    return {.optics = opticsByEntry(matter.volume(), scenes::ramp(0, 1000, opacity, 1.0)),
            .clip = {},
            .mask = nullptr};
}

TEST(CoarseMatterTest, KnowsAVoxelInEachEighthOfACell) {
    const glm::ivec3 size{40, 30, 20};
    const auto volume = scenes::volumeOf(size, scenes::grid({1.0, 1.0, 2.0}, size), [](int i, int j, int k) {
        return static_cast<std::uint16_t>(i + 50 * j + 2000 * k);
    });
    const CoarseMatter matter(volume, 200);
    EXPECT_LE(matter.cellCount(), 200u);
    EXPECT_GT(matter.cellCount(), 80u);
    EXPECT_NEAR(matter.cellMm().x, matter.cellMm().z, 2.0);
    for (std::size_t cell = 0; cell < matter.cellCount(); ++cell) {
        EXPECT_EQ(matter.indexOf(matter.cellAt(cell)), cell);
        for (std::size_t s = 0; s < CoarseMatter::kSamples; ++s) {
            const glm::ivec3 at = matter.voxelOf(cell, s);
            EXPECT_EQ(matter.cellOf(glm::dvec3(at)), cell);
            EXPECT_EQ(matter.entriesOf(cell)[s], matter.entryMap().entryOf(volume->stored(at.x, at.y, at.z)));
        }
    }
    EXPECT_EQ(matter.cellOf({-100.0, -100.0, -100.0}), 0u);
    EXPECT_EQ(matter.cellOf({1e9, 1e9, 1e9}), matter.cellCount() - 1);
}

TEST(CoarseMatterTest, IsOneCellOfOneVoxelAndOfAnyLimit) {
    const CoarseMatter one = cellsOf({1, 1, 1}, [](int, int, int) { return 900; });
    EXPECT_EQ(one.cellCount(), 1u);
    const glm::ivec3 size{24, 20, 16};
    const CoarseMatter least(
        scenes::volumeOf(size, scenes::grid({0.05, 50.0, 0.05}, size), scenes::blob(size, 900)), 1);
    EXPECT_EQ(least.cellCount(), 1u);
}

// Clips of each shape, turned, thin, and beyond the volume: each cell once, and no part that is not true of
// the samples of it and of its neighbours.
TEST(CoarseMatterTest, PartsOfAClipAreTrueOfEachSample) {
    const glm::ivec3 size{90, 18, 15};
    const auto volume = scenes::volumeOf(size, scenes::grid({1.0, 2.0, 1.5}, size), scenes::blob(size, 900));
    const CoarseMatter matter(volume, 3000);
    ASSERT_GT(matter.size().x, 24) << "several runs";
    const glm::dvec3 middle = volume->worldBox().centre();
    const glm::dvec3 slant = glm::normalize(glm::dvec3(1.0, 2.0, -0.5));
    std::vector<Clip> clips(9);
    clips[1].planes = {{.normal = slant, .offsetMm = glm::dot(slant, middle)}};
    clips[2].box = OrientedBox{.centreMm = middle, .axes = glm::dmat3(1.0), .halfSizeMm = glm::dvec3(6.0)};
    clips[3] = clips[2];
    clips[3].ofBox = Keep::outside;
    clips[4].box = OrientedBox{.centreMm = middle, .axes = glm::dmat3(1.0), .halfSizeMm = {0.1, 50.0, 50.0}};
    clips[5].cut = Octant{.pointMm = middle};
    clips[6].ball = Ball{.centreMm = middle, .radiusMm = 8.0};
    clips[7] = clips[6];
    clips[7].ofBall = Keep::outside;
    clips[8].ball = Ball{.centreMm = middle + 1e4, .radiusMm = 1.0};
    std::array<std::size_t, 3> counts{};
    for (const Clip& clip : clips) {
        ShownMatter shown = shownBy(matter, 0.5);
        shown.clip = clip;
        for (const int margin : {0, 1}) {
            std::vector<int> parts(matter.cellCount(), -1);
            forEachCell(matter, shown, margin, [&](std::size_t cell, PartShown part) {
                EXPECT_EQ(std::exchange(parts[cell], int(part)), -1) << "twice";
            });
            for (std::size_t cell = 0; cell < matter.cellCount(); ++cell) {
                ASSERT_GE(parts[cell], 0) << "never";
                const auto part = PartShown(parts[cell]);
                if (clip.hasShape() && clip != clips.back()) ++counts[std::size_t(parts[cell])];
                if (part == PartShown::some) continue;
                const glm::ivec3 at = matter.cellAt(cell);
                for (int k = 0; k < 27; ++k) {
                    const glm::ivec3 off = margin * glm::ivec3(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
                    const glm::ivec3 beside = glm::clamp(at + off, glm::ivec3(0), matter.size() - 1);
                    for (std::size_t s = 0; s < CoarseMatter::kSamples; ++s)
                        EXPECT_EQ(
                            shown.isInShape(*volume, glm::dvec3(matter.voxelOf(matter.indexOf(beside), s))),
                            part == PartShown::all);
                }
            }
        }
    }
    for (const std::size_t count : counts) EXPECT_GT(count, matter.cellCount() / 4);
}

// The same in double, cell by cell, by what a cell gets from the five behind it.
TEST(LitMatterTest, LightIsThatOfTheReference) {
    const glm::ivec3 size{7, 6, 5};
    std::mt19937 random(3);
    std::vector<std::uint16_t> values(std::size_t(size.x * size.y * size.z));
    for (auto& value : values) value = random() % 3 == 0 ? std::uint16_t(random() % 1000) : std::uint16_t(0);
    const CoarseMatter matter = cellsOf(
        size, [&](int i, int j, int k) { return values[std::size_t((k * size.y + j) * size.x + i)]; });
    ASSERT_EQ(matter.size(), size);
    const ShownMatter shown = shownBy(matter, 0.4);
    const LitMatter lit = litMatter(matter, shown);
    const auto extinction = [&](const glm::ivec3& at) {
        return double(shown.optics[matter.entriesOf(matter.indexOf(at))[0]].w);
    };
    for (std::size_t side = 0; side < 6; ++side) {
        const int axis = int(side / 2);
        const int step = side % 2 == 0 ? 1 : -1;  // from which side it comes
        const std::function<double(glm::ivec3)> leaving = [&](glm::ivec3 at) -> double {
            if (glm::any(glm::lessThan(at, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(at, size)))
                return 1.0;
            glm::ivec3 behind = at;
            behind[axis] -= step;
            double arriving = 1.0;
            if (behind[axis] >= 0 && behind[axis] < size[axis]) {
                arriving = 0.4 * leaving(behind);
                for (const int other : {(axis + 1) % 3, (axis + 2) % 3}) {
                    for (const int by : {-1, 1}) {
                        glm::ivec3 beside = behind;
                        beside[other] += by;
                        arriving += 0.15 * leaving(beside);
                    }
                }
            }
            const std::size_t cell = matter.indexOf(at);
            EXPECT_NEAR(double(lit.light[cell][side]), arriving, 1e-5);
            return arriving * std::exp(-2.0 * extinction(at));
        };
        glm::ivec3 last = size / 2;
        last[axis] = step > 0 ? size[axis] - 1 : 0;
        leaving(last);
    }
}

TEST(LitMatterTest, NothingIsWhollyOpenAndTheMiddleOfOpaqueMatterIsDark) {
    const glm::ivec3 size{21, 21, 21};
    const CoarseMatter matter = cellsOf(size, [](int i, int j, int k) {
        return glm::length(glm::dvec3(i, j, k) - 10.0) < 7.0 ? std::uint16_t(1000) : std::uint16_t(0);
    });
    ShownMatter shown = shownBy(matter, 0.999);
    const LitMatter lit = litMatter(matter, shown);
    EXPECT_LT(lit.openness(matter.indexOf({10, 10, 10})), 1e-3f);
    EXPECT_NEAR(lit.openness(matter.indexOf({0, 0, 0})), 1.0f, 1e-4f);
    const std::size_t front = matter.indexOf({4, 10, 10});
    EXPECT_GT(lightOn(matter, lit, front)[0], 0.99f);
    EXPECT_LT(lightOn(matter, lit, front)[1], 0.1f);
    EXPECT_GT(riseAround(matter, lit, front).x, 0.5f);
    shown.optics.assign(shown.optics.size(), glm::vec4(0.0f));
    const LitMatter none = litMatter(matter, shown);
    for (std::size_t cell = 0; cell < matter.cellCount(); ++cell)
        EXPECT_NEAR(none.openness(cell), 1.0f, 1e-4f);
}

TEST(LitMatterTest, WhatAClipOrAMaskHidesIsNotThere) {
    const glm::ivec3 size{10, 10, 10};
    const CoarseMatter matter = cellsOf(size, [](int, int, int) { return 1000; });
    ShownMatter shown = shownBy(matter, 0.5);
    shown.clip.planes = {{.normal = {1.0, 0.0, 0.0}, .offsetMm = 0.0}};
    MaskBits bits{.size = size, .words = std::vector<std::uint32_t>(32, ~0u)};
    bits.words[0] = 0;  // the first 32 voxels: of slice 0, rows 0 to 2 and two voxels of row 3
    shown.mask = std::make_shared<const MaskBits>(bits);
    const LitMatter lit = litMatter(matter, shown);
    for (int k = 0; k < size.z; ++k) {
        for (int j = 0; j < size.y; ++j) {
            for (int i = 0; i < size.x; ++i) {
                const bool isMasked = k == 0 && j * size.x + i < 32;
                EXPECT_EQ(lit.extinctionPerMm[matter.indexOf({i, j, k})] > 0.0f, i >= 5 && !isMasked)
                    << i << j << k;
            }
        }
    }
}

// A step of 800 along x, on voxels of 2 mm: at its two voxels the gradient is 200 per mm, elsewhere 0.
TEST(LitMatterTest, SteepMatterIsThereWhereValuesChange) {
    const glm::ivec3 size{10, 4, 4};
    const CoarseMatter matter = cellsOf(size, [](int i, int, int) { return i < 5 ? 100 : 900; });
    ShownMatter shown = shownBy(matter, 0.0);
    shown.steep = opticsByEntry(matter.volume(), scenes::homogeneous(0.6));
    shown.steepGradientPerMm = 100.0;
    const LitMatter lit = litMatter(matter, shown);
    for (int i = 0; i < size.x; ++i)
        EXPECT_NEAR(lit.extinctionPerMm[matter.indexOf({i, 2, 1})], i == 4 || i == 5 ? 0.6 * 0.8 : 0.0, 1e-5)
            << i;
    // Colours are mixed by extinction: here all of it is that of steep matter.
    const std::uint16_t entry = matter.entriesOf(matter.indexOf({5, 2, 1}))[0];
    const glm::vec4 optics = shown.opticsAt(matter, entry, {5, 2, 1});
    EXPECT_EQ(glm::vec3(optics), glm::vec3(shown.steep[entry]));
    shown.steepGradientPerMm = 400.0;
    EXPECT_NEAR(shown.opticsAt(matter, entry, {5, 2, 1}).w, 0.6 * 0.2, 1e-5);
    shown.optics = shown.steep;
    EXPECT_EQ(shown.opticsAt(matter, entry, {5, 2, 1}), shown.steep[entry]);
}

TEST(ReflectanceTest, IsThatOfAHalfSpace) {
    EXPECT_EQ(reflectanceOf(glm::vec3(1.0f)), glm::vec3(1.0f));
    EXPECT_EQ(reflectanceOf(glm::vec3(0.0f)), glm::vec3(0.0f));
    EXPECT_NEAR(reflectanceOf(glm::vec3(0.75f)).r, 1.0 / 3.0, 1e-6);
    EXPECT_EQ(reflectanceOf(glm::vec3(7.0f, -2.0f, 0.0f)), glm::vec3(1.0f, 0.0f, 0.0f));
}

TEST(LightOfSidesTest, LightFromTheLeftIsFromTheLeftHoweverTheGridLies) {
    // Columns begin behind the patient, and come by his left to where he looks.
    std::vector<glm::vec3> sky(16 * 8, glm::vec3(0.2f));
    for (int row = 2; row < 6; ++row)
        for (int column = 2; column < 6; ++column) sky[std::size_t(row * 16 + column)] = glm::vec3(3.0f);
    const trace::Environment environment = *trace::Environment::fromImage(16, 8, sky);
    const LightOfSides straight = lightOf(environment, glm::dmat3(1.0));
    const LightOfSides turned = lightOf(environment, glm::dmat3(-2.0, 0, 0, 0, 0, 1, 0, 1, 0));
    for (std::size_t side = 0; side < 6; ++side) {
        if (side != 1) {
            EXPECT_GT(straight.radiance[1].r, 1.5f * straight.radiance[side].r);  // +x is left
        }
        if (side != 0) {
            EXPECT_GT(turned.radiance[0].r, 1.5f * turned.radiance[side].r);
        }
    }
    const LightOfSides even = lightOf(trace::Environment::constant(glm::vec3(0.6f)), glm::dmat3(1.0));
    // On a surface that three sides light.
    EXPECT_NEAR(even.at({0, 1, 0, 1, 0, 1}).g, 0.6f, 1e-3f);
}

TEST(LightOfSidesTest, WhatAModelLearntTellsTheLight) {
    LightOfSides truth;
    truth.radiance = {glm::vec3(0.1f), glm::vec3(0.8f, 0.7f, 0.6f),
                      glm::vec3(0.0f), glm::vec3(0.3f),
                      glm::vec3(0.2f), glm::vec3(0.5f),
                      glm::vec3(0.05f)};
    std::mt19937 random(11);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    std::vector<LitSample> samples;
    for (int i = 0; i < 2000; ++i) {
        LitSample sample{.light = {},
                         .reflectance = glm::vec3(unit(random), 1.0f, 1.0f),
                         .radiance = {},
                         .weight = unit(random)};
        for (float& part : sample.light) part = unit(random) < 0.5f ? 0.0f : unit(random);
        sample.radiance = sample.reflectance * truth.at(sample.light);
        samples.push_back(sample);
    }
    LightOfSides expected;
    expected.radiance.fill(glm::vec3(0.2f));
    const LightOfSides found = fittedLight(samples, expected);
    for (std::size_t i = 0; i < truth.radiance.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(found.radiance[i][c], truth.radiance[i][c], 0.06f) << i;
            EXPECT_GE(found.radiance[i][c], 0.0f);
        }
    }
    EXPECT_EQ(fittedLight({}, expected).radiance, expected.radiance);
    for (LitSample& sample : samples) sample.reflectance = sample.radiance = glm::vec3(0.0f);
    EXPECT_NEAR(fittedLight(samples, expected).radiance[3].g, 0.2f, 1e-6f) << "black matter tells nothing";
}

}  // namespace
}  // namespace macula::hybrid
