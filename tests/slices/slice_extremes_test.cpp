// What no scanner sends and no hand asks for, and what happens then.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <functional>
#include <limits>

#include "made_volumes.h"
#include "slices/sampled_slice.h"
#include "slices/slab_steps.h"

namespace macula::slices::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr float kNoVoxel = std::numeric_limits<float>::quiet_NaN();

std::size_t valuesIn(const SampledSlice& slice) {
    std::size_t count = 0;
    for (const float value : slice.values) count += std::isnan(value) ? 0 : 1;
    return count;
}

// The two slices have the same values, and NaN at the same places.
void expectSame(const SampledSlice& a, const SampledSlice& b) {
    ASSERT_EQ(a.values.size(), b.values.size());
    std::size_t different = 0;
    for (std::size_t n = 0; n < a.values.size(); ++n) {
        const bool isSame =
            a.values[n] == b.values[n] || (std::isnan(a.values[n]) && std::isnan(b.values[n]));
        different += isSame ? 0 : 1;
    }
    EXPECT_EQ(different, 0u);
}

SliceFrame axialFrame(const Volume& volume, double mmPerPixel, const glm::ivec2& sizePx) {
    return {
        .plane = planeOf(Orientation::axial, middleMm(volume)), .mmPerPixel = mmPerPixel, .sizePx = sizePx};
}

TEST(SliceExtremes, OneVoxelIsASquareOfItsSize) {
    const Volume volume = volumeOf({1, 1, 1}, affine({2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {7, 8, 9}), {42.0F});
    for (const Filter filter : {Filter::nearest, Filter::linear}) {
        const SampledSlice slice = sampleSlice(volume, axialFrame(volume, 1.0, {4, 4}), {}, filter);
        EXPECT_EQ(valuesIn(slice), 4u);
        for (const std::size_t n : {5u, 6u, 9u, 10u}) EXPECT_EQ(slice.values[n], 42.0F);
    }
    SliceFrame beside = axialFrame(volume, 1.0, {4, 4});
    beside.plane.centreMm.z += 1.1;
    EXPECT_EQ(valuesIn(sampleSlice(volume, beside, {}, Filter::linear)), 0u);
    // A slab reaches it, and what of the slab is outside does not count.
    for (const Projection projection : {Projection::mean, Projection::maximum, Projection::minimum}) {
        const SampledSlice slab = sampleSlice(volume, beside, {1.0, projection}, Filter::linear);
        EXPECT_EQ(valuesIn(slab), 4u);
        EXPECT_EQ(slab.values[5], 42.0F);
    }
}

TEST(SliceExtremes, PaddingAloneIsNothing) {
    const auto all = Volume::create({.size = {3, 3, 3},
                                     .worldFromVoxel = glm::dmat4(1.0),
                                     .unitsFromStored = {},
                                     .unit = Unit::raw,
                                     .modality = "MR",
                                     .padding = StoredRange{0, 65535},
                                     .provenance = {}},
                                    std::vector<std::uint16_t>(27, 65535));
    ASSERT_TRUE(all.ok());
    const Volume noNumbers = volumeOf({3, 3, 3}, glm::dmat4(1.0), std::vector<float>(27, kNoVoxel));
    for (const Volume* volume : {&*all, &noNumbers}) {
        for (const Filter filter : {Filter::nearest, Filter::linear}) {
            for (const double thickness : {0.0, 2.0}) {
                const SampledSlice slice =
                    sampleSlice(*volume, axialFrame(*volume, 0.5, {8, 8}), {thickness}, filter);
                EXPECT_EQ(slice.values.size(), 64u);
                EXPECT_EQ(valuesIn(slice), 0u);
            }
        }
    }
}

TEST(SliceExtremes, StoredZeroIsPaddingOnlyWhereTheFileSaysSo) {
    for (const bool isPadding : {false, true}) {
        VolumeOptions options{.size = {1, 1, 1},
                              .worldFromVoxel = glm::dmat4(1.0),
                              .unitsFromStored = {},
                              .unit = Unit::raw,
                              .modality = "MR",
                              .padding = {},
                              .provenance = {}};
        if (isPadding) options.padding = StoredRange{0, 0};
        const Volume volume = Volume::create(std::move(options), {0}).value();
        const SampledSlice slice = sampleSlice(volume, axialFrame(volume, 0.5, {1, 1}), {}, Filter::linear);
        EXPECT_EQ(valuesIn(slice), isPadding ? 0u : 1u);
    }
}

TEST(SliceExtremes, NanAmongVoxelsLeavesTheOthersAsTheyAre) {
    const Volume volume = volumeOf({3, 1, 1}, glm::dmat4(1.0), {5.0F, kNoVoxel, 9.0F});
    SliceFrame frame = axialFrame(volume, 0.25, {12, 1});  // x from -0.5 to 2.5
    const SampledSlice slice = sampleSlice(volume, frame, {}, Filter::linear);
    for (std::size_t n = 0; n < 6; ++n) EXPECT_EQ(slice.values[n], 5.0F) << n;
    for (std::size_t n = 6; n < 12; ++n) EXPECT_EQ(slice.values[n], 9.0F) << n;
    frame.sizePx = {1, 1};  // the middle of the one that is NaN
    EXPECT_TRUE(std::isnan(sampleSlice(volume, frame, {}, Filter::linear).values[0]));
    EXPECT_TRUE(std::isnan(sampleSlice(volume, frame, {}, Filter::nearest).values[0]));
}

TEST(SliceExtremes, HugeValuesStayTheirs) {
    const Volume volume = volumeOf({2, 1, 1}, glm::dmat4(1.0), {1e30F, -1e30F});
    const SampledSlice slice = sampleSlice(volume, axialFrame(volume, 0.5, {3, 1}), {}, Filter::linear);
    EXPECT_EQ(slice.values[0], 1e30F);  // at 0, 0.5 and 1
    EXPECT_EQ(slice.values[1], 0.0F);
    EXPECT_EQ(slice.values[2], -1e30F);

    constexpr float kMost = std::numeric_limits<float>::max();
    const Volume largest = volumeOf({1, 1, 9}, glm::dmat4(1.0), std::vector<float>(9, kMost));
    const SampledSlice mean = sampleSlice(largest, axialFrame(largest, 0.5, {1, 1}), {7.0}, Filter::linear);
    EXPECT_EQ(mean.values[0], kMost);
    const Volume small = volumeOf({2, 1, 1}, glm::dmat4(1.0), {1e30F, 1.0F});
    SliceFrame frame = axialFrame(small, 0.5, {1, 1});
    frame.plane.centreMm.x = 1.0;
    EXPECT_EQ(sampleSlice(small, frame, {}, Filter::linear).values[0], 1.0F);
}

TEST(SliceExtremes, AMillionToOneTakesNoLongerThanOthers) {
    const Volume volume =
        storedVolume({64, 64, 64}, affine({1, 0, 0}, {0, 1e-6, 0}, {0, 0, 1}, {-32, 0, -32}), Padding::none);
    Random random(4);
    for (int n = 0; n < 3; ++n) {
        const SliceFrame frame{.plane = n == 0 ? planeOf(Orientation::axial, middleMm(volume))
                                               : randomPlane(middleMm(volume), random),
                               .mmPerPixel = 4.0,
                               .sizePx = {5, 5}};
        EXPECT_LE(stepsThrough(volume, frame.plane, kInfinity).size(), std::size_t(kMostSlabSteps) + 3);
        const SampledSlice slice =
            sampleSlice(volume, frame, {kInfinity, Projection::maximum}, Filter::linear);
        EXPECT_FALSE(std::isnan(slice.values[12]));  // the plane itself is among the steps
    }
    const glm::dvec3 middle = middleMm(volume);
    const SliceFrame across{.plane = {.centreMm = middle, .right = {1, 0, 0}, .down = {0, 0, 1}},
                            .mmPerPixel = 1.0,
                            .sizePx = {64, 64}};
    EXPECT_EQ(valuesIn(sampleSlice(volume, across, {}, Filter::linear)), 64u * 64u);
    EXPECT_DOUBLE_EQ(stepMm(volume, across.plane), 1e-6);
}

TEST(SliceExtremes, ASlabIsNotDeeperThanTheVolume) {
    Random random(9);
    for (const Pose& pose : poses()) {
        SCOPED_TRACE(pose.name);
        const Volume volume = storedVolume({9, 11, 7}, pose.worldFromVoxel, Padding::some);
        const double diagonal = volume.worldBox().diagonal();
        const SliceFrame frame{.plane = randomPlane(randomPointMm(volume, random), random),
                               .mmPerPixel = diagonal / 20.0,
                               .sizePx = {20, 20}};
        for (const Projection projection : {Projection::mean, Projection::maximum}) {
            const SampledSlice all = sampleSlice(volume, frame, {4.0 * diagonal, projection}, Filter::linear);
            EXPECT_GT(valuesIn(all), 10u);
            for (const double thickness : {1e9, 1e300, kInfinity})
                expectSame(sampleSlice(volume, frame, {thickness, projection}, Filter::linear), all);
        }
        const SampledSlice plane = sampleSlice(volume, frame, {}, Filter::linear);
        for (const double thickness : {-1.0, kNan, -kInfinity})
            expectSame(sampleSlice(volume, frame, {thickness}, Filter::linear), plane);
    }
}

TEST(SliceExtremes, AFrameThatIsNoneIsAllNan) {
    const Volume volume = storedVolume({5, 5, 5}, glm::dmat4(1.0), Padding::none);
    const SliceFrame good = axialFrame(volume, 0.5, {6, 7});
    ASSERT_EQ(valuesIn(sampleSlice(volume, good, {}, Filter::linear)), 42u);
    std::vector<SliceFrame> bad;
    for (const double scale : {0.0, -0.5, kNan, kInfinity}) {
        bad.push_back(good);
        bad.back().mmPerPixel = scale;
    }
    for (const double number : {kNan, kInfinity}) {
        bad.push_back(good);
        bad.back().plane.centreMm.y = number;
        bad.push_back(good);
        bad.back().plane.right.x = number;
        bad.push_back(good);
        bad.back().plane.down.z = number;
    }
    for (const glm::dvec3& right : {glm::dvec3(0.0), glm::dvec3(0, 1, 0), glm::dvec3(2, 0, 0)}) {
        bad.push_back(good);
        bad.back().plane.right = right;
    }
    for (const SliceFrame& frame : bad) {
        EXPECT_FALSE(frame.isUsable());
        for (const double thickness : {0.0, 3.0}) {
            const SampledSlice slice = sampleSlice(volume, frame, {thickness}, Filter::linear);
            EXPECT_EQ(slice.sizePx, glm::ivec2(6, 7));
            EXPECT_EQ(slice.values.size(), 42u);
            EXPECT_EQ(valuesIn(slice), 0u);
        }
    }
}

TEST(SliceExtremes, FarAwayIsNothing) {
    const Volume volume = storedVolume({5, 5, 5}, glm::dmat4(1.0), Padding::none);
    for (const double away : {1e3, 1e9, 1e100, 1e300, -1e308}) {
        for (int axis = 0; axis < 3; ++axis) {
            SliceFrame frame = axialFrame(volume, 0.5, {6, 7});
            frame.plane.centreMm[axis] += away;
            for (const double thickness : {0.0, 3.0})
                EXPECT_EQ(valuesIn(sampleSlice(volume, frame, {thickness}, Filter::linear)), 0u);
        }
    }
    // Scales at which all pixels are one place, or only the middle is near.
    EXPECT_EQ(valuesIn(sampleSlice(volume, axialFrame(volume, 1e-300, {6, 7}), {}, Filter::linear)), 42u);
    EXPECT_LE(valuesIn(sampleSlice(volume, axialFrame(volume, 1e300, {7, 7}), {}, Filter::linear)), 1u);
}

TEST(SliceExtremes, NoPixelsAndTooManyAreAnEmptySlice) {
    const Volume volume = storedVolume({5, 5, 5}, glm::dmat4(1.0), Padding::none);
    constexpr int kMost = std::numeric_limits<int>::max();
    for (const glm::ivec2& size :
         {glm::ivec2(0, 0), glm::ivec2(0, 9), glm::ivec2(9, 0), glm::ivec2(-4, 4), glm::ivec2(-4, -4),
          glm::ivec2(kMost, kMost), glm::ivec2(kMost, 1), glm::ivec2(std::numeric_limits<int>::min(), 3)}) {
        const SampledSlice slice = sampleSlice(volume, axialFrame(volume, 1.0, size), {}, Filter::linear);
        EXPECT_EQ(slice.sizePx, glm::ivec2(0));
        EXPECT_TRUE(slice.values.empty());
    }
    EXPECT_EQ(fittedMmPerPixel(volume, {}, {0, 5}), 1.0);
}

TEST(SliceExtremes, CancelledIsEmpty) {
    const Volume volume = storedVolume({5, 5, 5}, glm::dmat4(1.0), Padding::none);
    const SliceFrame frame = axialFrame(volume, 0.1, {40, 400});
    std::atomic<int> asked{0};
    const SampledSlice none = sampleSlice(volume, frame, {}, Filter::linear, [&] { return ++asked > 0; });
    EXPECT_EQ(none.sizePx, glm::ivec2(0));
    EXPECT_TRUE(none.values.empty());
    EXPECT_GE(asked, 1);
    EXPECT_LT(asked, 400);
    asked = 0;
    const SampledSlice late = sampleSlice(volume, frame, {}, Filter::linear, [&] { return ++asked > 100; });
    EXPECT_TRUE(late.values.empty());
    EXPECT_LT(asked, 400);
    asked = 0;
    const SampledSlice whole = sampleSlice(volume, frame, {}, Filter::linear, [&] { return ++asked < 0; });
    EXPECT_EQ(whole.values.size(), 16000u);
    EXPECT_EQ(asked, 400);
}

}  // namespace
}  // namespace macula::slices::test
