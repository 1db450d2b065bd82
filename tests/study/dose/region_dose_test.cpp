// Dose in regions: histograms of closed form.
#include "study/dose/region_dose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "base/frames.h"

namespace macula::study {
namespace {

std::shared_ptr<const Volume> doseOf(const glm::ivec3& size, const glm::dmat4& worldFromVoxel,
                                     const std::function<double(const glm::dvec3&)>& gy) {
    std::vector<float> values;
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i)
                values.push_back(float(gy(glm::dvec3(worldFromVoxel * glm::dvec4(i, j, k, 1)))));
    return std::make_shared<const Volume>(*Volume::createFloat(
        {.size = size, .worldFromVoxel = worldFromVoxel, .modality = "RTDOSE", .unitName = "Gy"}, values));
}

VoxelSet box(const glm::ivec3& low, const glm::ivec3& high) {
    VoxelSet set(low, high);
    for (int k = low.z; k <= high.z; ++k)
        for (int j = low.y; j <= high.y; ++j)
            for (int i = low.x; i <= high.x; ++i) set.add({i, j, k});
    return set;
}

RegionDose doseIn(const VoxelSet& region, const DoseField& field) {
    Progress progress;
    auto made = study::doseIn(region, glm::dmat4(1.0), field, progress);
    EXPECT_TRUE(made);
    return made ? *std::move(made) : RegionDose{};
}

TEST(DoseHistogram, OfARampIsStraight) {
    std::vector<float> samples;
    constexpr int kCount = 1000;
    for (int i = kCount; i-- > 0;) samples.push_back(float((i + 0.5) / kCount * 60.0));
    const DoseHistogram histogram(samples);
    EXPECT_NEAR(histogram.mean(), 30.0, 1e-4);
    for (const double share : {0.98, 0.95, 0.9, 0.5, 0.1, 0.02}) {
        EXPECT_NEAR(histogram.doseAt(share), 60.0 * (1.0 - share), 1e-4) << share;
        EXPECT_NEAR(histogram.shareAt(60.0 * (1.0 - share)), share, 1e-6) << share;
    }
    EXPECT_EQ(histogram.shareAt(-1.0), 1.0);
    EXPECT_EQ(histogram.shareAt(60.0), 0.0);
}

TEST(DoseHistogram, OfOneDoseIsAStep) {
    const DoseHistogram histogram(std::vector<float>(50, 40.0f));
    EXPECT_EQ(histogram.shareAt(40.0), 1.0);
    EXPECT_EQ(histogram.shareAt(40.001), 0.0);
    for (const double share : {0.0, 0.02, 0.5, 1.0}) EXPECT_EQ(histogram.doseAt(share), 40.0);
    const DoseHistogram one({7.0f});
    EXPECT_EQ(one.doseAt(0.95), 7.0);
    EXPECT_EQ(one.mean(), 7.0);
}

TEST(DoseHistogram, OfNothingHasNoFigures) {
    const DoseHistogram histogram(std::vector<float>{});
    EXPECT_TRUE(histogram.isEmpty());
    for (const double value : {histogram.minimum(), histogram.maximum(), histogram.mean(),
                               histogram.doseAt(0.5), histogram.shareAt(1.0)})
        EXPECT_TRUE(std::isnan(value));
}

TEST(DoseField, IsLinearBetweenPointsAndNothingOutside) {
    const auto gy = [](const glm::dvec3& mm) { return 3.0 + 0.5 * mm.x - 0.25 * mm.y + 2.0 * mm.z; };
    const glm::dmat4 pose = affine({2, 1, 0}, {-1, 2, 0}, {0, 0, 3}, {5, 6, 7});
    const DoseField field(doseOf({5, 6, 4}, pose, gy));
    for (const glm::dvec3& at : {glm::dvec3(0.0), glm::dvec3(1.3, 2.7, 1.9), glm::dvec3(4, 5, 3)}) {
        const glm::dvec3 mm(pose * glm::dvec4(at, 1));
        ASSERT_TRUE(field.at(mm));
        EXPECT_NEAR(*field.at(mm), gy(mm), 1e-5);
    }
    for (const glm::dvec3& at : {glm::dvec3(-0.1, 2, 1), glm::dvec3(2, 5.1, 1), glm::dvec3(2, 2, 3.4)})
        EXPECT_FALSE(field.at(glm::dvec3(pose * glm::dvec4(at, 1))));
    EXPECT_FALSE(field.at(glm::dvec3(std::numeric_limits<double>::quiet_NaN())));
    EXPECT_FALSE(field.at(glm::dvec3(std::numeric_limits<double>::infinity())));
}

TEST(DoseField, OfOnePlaneIsHalfAVoxelThick) {
    const DoseField field(doseOf({4, 4, 1}, affine({2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {}),
                                 [](const glm::dvec3& mm) { return mm.x; }));
    EXPECT_TRUE(field.at({3, 3, 0.9}));
    EXPECT_FALSE(field.at({3, 3, 1.1}));
}

TEST(RegionDose, OfALinearRampInABoxIsALinearHistogram) {
    // Each voxel of 1 mm has its own dose: 5 Gy and 1 Gy for each mm.
    const DoseField field(
        doseOf({50, 12, 12}, glm::dmat4(1.0), [](const glm::dvec3& mm) { return 5.0 + mm.x; }));
    const RegionDose many = doseIn(box({2, 2, 2}, {41, 9, 9}), field);
    EXPECT_EQ(many.samplesPerVoxel, glm::ivec3(1));
    EXPECT_EQ(many.voxels, 40u * 8 * 8);
    EXPECT_EQ(many.outside, 0u);
    // Doses from 6.5 to 46.5 Gy, in 40 steps.
    EXPECT_NEAR(many.histogram.mean(), 26.5, 1e-5);
    for (const double share : {0.95, 0.75, 0.5, 0.25, 0.05})
        EXPECT_NEAR(many.histogram.doseAt(share), 46.5 - 40.0 * share, 0.51) << share;
    const RegionDose few = doseIn(box({2, 5, 5}, {41, 5, 5}), field);
    EXPECT_GT(few.samplesPerVoxel.x, 1) << "40 voxels are few";
    const double stepGy = 1.0 / few.samplesPerVoxel.x;
    for (const double share : {0.95, 0.75, 0.5, 0.25, 0.05})
        EXPECT_NEAR(few.histogram.doseAt(share), 46.5 - 40.0 * share, 0.51 * stepGy) << share;
    EXPECT_NEAR(few.histogram.mean(), 26.5, 1e-4);
}

TEST(RegionDose, LargeVoxelsAreDivided) {
    const DoseField field(doseOf({30, 30, 30}, affine({0.5, 0, 0}, {0, 1, 0}, {0, 0, 0.3}, {}),
                                 [](const glm::dvec3& mm) { return mm.x; }));
    const RegionDose made = doseIn(box({1, 1, 1}, {6, 6, 6}), field);
    EXPECT_EQ(made.samplesPerVoxel, glm::ivec3(2, 1, 4));
    EXPECT_NEAR(made.histogram.minimum(), 0.75, 1e-6);
    EXPECT_NEAR(made.histogram.mean(), 3.5, 1e-5);
}

TEST(RegionDose, WhatLiesOutsideTheDoseIsCounted) {
    const DoseField field(doseOf({10, 10, 10}, glm::dmat4(1.0), [](const glm::dvec3&) { return 2.0; }));
    const RegionDose half = doseIn(box({5, 2, 2}, {14, 6, 6}), field);
    EXPECT_EQ(half.samples, 250u);
    EXPECT_EQ(half.outside, 125u);
    EXPECT_EQ(half.outsideShare(), 0.5);
    EXPECT_EQ(half.histogram.minimum(), 2.0) << "no dose outside is not a dose of 0";
    const RegionDose all = doseIn(box({20, 2, 2}, {24, 6, 6}), field);
    EXPECT_EQ(all.outsideShare(), 1.0);
    EXPECT_TRUE(all.histogram.isEmpty());
    EXPECT_EQ(doseIn(VoxelSet(), field).samples, 0u);
}

TEST(RegionDose, PointsWithoutAValueAreNoDose) {
    const DoseField field(doseOf({10, 10, 10}, glm::dmat4(1.0), [](const glm::dvec3& mm) {
        return mm.x < 4.0 ? std::numeric_limits<double>::quiet_NaN() : 3.0;
    }));
    const RegionDose made = doseIn(box({0, 0, 0}, {7, 9, 9}), field);
    EXPECT_EQ(made.outsideShare(), 0.5);
    EXPECT_EQ(made.histogram.mean(), 3.0);
}

TEST(RegionDose, CanBeCancelled) {
    const DoseField field(doseOf({10, 10, 10}, glm::dmat4(1.0), [](const glm::dvec3&) { return 2.0; }));
    CancelToken token;
    token.cancel();
    Progress progress({}, token);
    const auto made = study::doseIn(box({0, 0, 0}, {9, 9, 9}), glm::dmat4(1.0), field, progress);
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace macula::study
