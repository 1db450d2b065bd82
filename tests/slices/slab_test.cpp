// Thick slabs: against closed forms, against all that lies in them, and against their steps one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/worst.h"
#include "made_volumes.h"
#include "slices/sampled_slice.h"
#include "slices/slab_steps.h"

namespace macula::slices::test {
namespace {

using macula::test::worse;

constexpr std::array kProjections{Projection::mean, Projection::maximum, Projection::minimum};

// A projection of values with weights, those that are NaN left out.
class Projected {
  public:
    void add(double value, double weight) {
        if (std::isnan(value)) return;
        sum_ += weight * value;
        weights_ += weight;
        highest_ = std::isnan(highest_) ? value : std::max(highest_, value);
        lowest_ = std::isnan(lowest_) ? value : std::min(lowest_, value);
    }
    double of(Projection projection) const {
        switch (projection) {
            case Projection::mean:
                break;
            case Projection::maximum:
                return highest_;
            case Projection::minimum:
                return lowest_;
        }
        return sum_ / weights_;  // NaN when there is none
    }

  private:
    double sum_ = 0.0;
    double weights_ = 0.0;
    double highest_ = std::nan("");
    double lowest_ = std::nan("");
};

// Through five slices: their highest and lowest values exactly, and the integral of what is linear between.
TEST(Slab, ThroughTheMiddlesOfSlicesMeetsAllOfThem) {
    const glm::ivec3 size{13, 11, 12};
    const Volume volume =
        storedVolume(size, affine({0.8, 0, 0}, {0, 0.8, 0}, {0, 0, 2.5}, {3, 4, -500}), Padding::none);
    const int k = 5;
    const glm::dvec3 centre =
        transformPoint(volume.worldFromVoxel(), {0.5 * (size.x - 1), 0.5 * (size.y - 1), k});
    const SliceFrame frame{
        .plane = planeOf(Orientation::axial, centre), .mmPerPixel = 0.8, .sizePx = {size.x, size.y}};
    for (const Projection projection : kProjections) {
        const SampledSlice slice =
            sampleSlice(volume, frame, {.thicknessMm = 10.0, .projection = projection}, Filter::linear);
        for (int j = 0; j < size.y; ++j) {
            for (int i = 0; i < size.x; ++i) {
                Projected wanted;
                for (int n = -2; n <= 2; ++n)
                    wanted.add(volume.value(i, j, k + n), std::abs(n) == 2 ? 0.5 : 1.0);
                const float found = slice.values[std::size_t(j * size.x + i)];
                if (projection == Projection::mean)
                    ASSERT_NEAR(found, wanted.of(projection), 0.01);
                else
                    ASSERT_EQ(found, static_cast<float>(wanted.of(projection)));
            }
        }
    }
}

// Values that rise evenly: the mean is the plane's, and the ends are half a thickness up and down the slope.
TEST(Slab, OfASlopeReachesHalfItsThicknessToBothSides) {
    const glm::ivec3 size(31);
    const glm::dvec3 slope{3.0, -5.0, 7.0};  // by voxel
    std::vector<float> values;
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i)
                values.push_back(static_cast<float>(glm::dot(slope, glm::dvec3(i, j, k))));
    Random random(5);
    for (const Pose& pose : poses()) {
        SCOPED_TRACE(pose.name);
        const Volume volume = volumeOf(size, pose.worldFromVoxel, values);
        const glm::dmat3 voxelFromMm = glm::inverse(glm::dmat3(pose.worldFromVoxel));
        for (int n = 0; n < 20; ++n) {
            const SliceFrame frame{
                .plane = randomPlane(middleMm(volume), random), .mmPerPixel = 0.1, .sizePx = {3, 3}};
            const double thickness = uniform(random, 0.01, 8.0);
            const double middle = glm::dot(slope, glm::dvec3(15.0));
            const double reach =
                std::abs(glm::dot(slope, voxelFromMm * frame.plane.normal())) * thickness / 2.0;
            for (const Projection projection : kProjections) {
                const double sign = projection == Projection::mean      ? 0.0
                                    : projection == Projection::maximum ? 1.0
                                                                        : -1.0;
                const SampledSlice slice =
                    sampleSlice(volume, frame, {thickness, projection}, Filter::linear);
                EXPECT_NEAR(slice.values[4], middle + sign * reach, 1e-3);
            }
        }
    }
}

// Against a thousand values through the slab, where values change smoothly.
TEST(Slab, IsOverAllThatLiesInIt) {
    const glm::ivec3 size(24);
    std::vector<float> values;
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i)
                values.push_back(static_cast<float>(1000.0 * std::sin(0.4 * i + 1.0) * std::cos(0.35 * j) *
                                                    std::sin(0.3 * k + 0.5)));
    Random random(6);
    int compared = 0;
    for (const Pose& pose : poses()) {
        SCOPED_TRACE(pose.name);
        const Volume volume = volumeOf(size, pose.worldFromVoxel, values);
        const SliceFrame frame{
            .plane = randomPlane(middleMm(volume), random), .mmPerPixel = 1.0, .sizePx = {5, 4}};
        const double thickness = uniform(random, 4.0, 12.0);
        for (const Projection projection : kProjections) {
            const SampledSlice slice = sampleSlice(volume, frame, {thickness, projection}, Filter::linear);
            for (int y = 0; y < 4; ++y) {
                for (int x = 0; x < 5; ++x) {
                    const glm::dvec3 mm = frame.worldFromPicture({x + 0.5, y + 0.5});
                    constexpr int kMany = 1000;
                    Projected wanted;
                    int there = 0;
                    for (int n = 0; n < kMany; ++n) {
                        const double depth = thickness * ((n + 0.5) / kMany - 0.5);
                        const double value = valueAt(volume, mm + depth * frame.plane.normal());
                        there += std::isnan(value) ? 0 : 1;
                        wanted.add(value, 1.0);
                    }
                    // Of a line that leaves the volume, a step more or less has too much weight.
                    if (there < kMany) continue;
                    EXPECT_NEAR(slice.values[std::size_t(y * 5 + x)], wanted.of(projection), 40.0);
                    ++compared;
                }
            }
        }
    }
    EXPECT_GT(compared, 200);
}

// Noise, padding and lines that leave the volume: whatever the steps are, the projection is of them.
TEST(Slab, LeavesOutWhatHasNoValue) {
    Random random(7);
    for (const Pose& pose : poses()) {
        SCOPED_TRACE(pose.name);
        for (const Volume& volume : {storedVolume({9, 11, 7}, pose.worldFromVoxel, Padding::some),
                                     floatVolume({9, 11, 7}, pose.worldFromVoxel, Padding::some)}) {
            const SliceFrame frame{.plane = randomPlane(randomPointMm(volume, random), random),
                                   .mmPerPixel = volume.worldBox().diagonal() / 25.0,
                                   .sizePx = {23, 19}};
            const double thickness = uniform(random, 1.0, 9.0);
            const auto steps = stepsThrough(volume, frame.plane, thickness);
            for (const Projection projection : kProjections) {
                const SampledSlice slice =
                    sampleSlice(volume, frame, {thickness, projection}, Filter::linear);
                double worst = 0.0;
                int compared = 0;
                for (int y = 0; y < 19; ++y) {
                    for (int x = 0; x < 23; ++x) {
                        const glm::dvec3 mm = frame.worldFromPicture({x + 0.5, y + 0.5});
                        Projected wanted;
                        bool isSure = true;
                        for (const SlabStep& step : steps) {
                            const glm::dvec3 at = mm + step.depthMm * frame.plane.normal();
                            isSure = isSure && !isAtJump(volume, at);
                            wanted.add(valueAt(volume, at), step.weight);
                        }
                        if (!isSure) continue;
                        const double value = wanted.of(projection);
                        const double found = slice.values[std::size_t(y * 23 + x)];
                        ASSERT_EQ(std::isnan(value), std::isnan(found));
                        if (std::isnan(value)) continue;
                        worst = worse(worst, std::abs(found - value));
                        ++compared;
                    }
                }
                EXPECT_LT(worst, 0.02);
                EXPECT_GT(compared, 10);
            }
        }
    }
}

TEST(SlabSteps, AreFineEvenAndReachBothEnds) {
    Random random(8);
    for (const Pose& pose : poses()) {
        SCOPED_TRACE(pose.name);
        const Volume volume = storedVolume({40, 40, 40}, pose.worldFromVoxel, Padding::none);
        const glm::dvec3 sides = volume.spacingMm();
        const double longest = 0.5 * std::min({sides.x, sides.y, sides.z});
        for (int n = 0; n < 20; ++n) {
            const glm::dvec3 centre = middleMm(volume);
            const SlicePlane plane = n % 2 == 0 ? randomPlane(centre, random) : acquiredPlane(volume, centre);
            const double thickness = uniform(random, 0.01, 8.0);
            const auto steps = stepsThrough(volume, plane, thickness);
            ASSERT_GE(steps.size(), 3u);
            EXPECT_DOUBLE_EQ(steps.front().depthMm, -thickness / 2.0);
            EXPECT_DOUBLE_EQ(steps.back().depthMm, thickness / 2.0);
            double weights = 0.0;
            for (std::size_t s = 0; s < steps.size(); ++s) {
                weights += steps[s].weight;
                const SlabStep& opposite = steps[steps.size() - 1 - s];
                EXPECT_NEAR(steps[s].depthMm, -opposite.depthMm, 1e-12);
                EXPECT_NEAR(steps[s].weight, opposite.weight, 1e-12);
                if (s == 0) continue;
                EXPECT_GT(steps[s].depthMm, steps[s - 1].depthMm);
                EXPECT_LE(steps[s].depthMm - steps[s - 1].depthMm, longest * (1.0 + 1e-6));
            }
            EXPECT_NEAR(weights, thickness, 1e-9);
        }
    }
}

TEST(SlabSteps, ThroughNothingAreThePlaneAlone) {
    const Volume volume = storedVolume({4, 4, 4}, glm::dmat4(1.0), Padding::none);
    for (const double thickness : {0.0, -3.0, std::nan("")}) {
        const auto steps = stepsThrough(volume, {}, thickness);
        ASSERT_EQ(steps.size(), 1u);
        EXPECT_EQ(steps[0].depthMm, 0.0);
    }
}

}  // namespace
}  // namespace macula::slices::test
