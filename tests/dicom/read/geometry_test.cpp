#include "dicom/stack/geometry.h"

#include <gtest/gtest.h>

#include "support.h"

namespace macula::dicom::test {
namespace {

std::vector<StackedPlane> evenStack(int count, double stepMm) {
    std::vector<StackedPlane> planes;
    for (int k = 0; k < count; ++k) {
        planes.push_back(
            {ImagePlane{
                 .positionMm = {-10.0, 5.0, 3.0 + k * stepMm}, .columnSpacingMm = 0.5, .rowSpacingMm = 0.75},
             k + 1});
    }
    return planes;
}

std::string onlyKey(const StackGeometry& stack) {
    return stack.messages.size() == 1 ? stack.messages[0].key : "not one message";
}

bool has(const StackGeometry& stack, std::string_view key) {
    return std::any_of(stack.messages.begin(), stack.messages.end(),
                       [&](const Message& message) { return message.key == key; });
}

TEST(Geometry, SpacingIsBetweenColumnsThenRows) {
    const StackGeometry stack = stackPlanes(evenStack(4, 2.0));
    ASSERT_TRUE(stack.worldFromVoxel);
    EXPECT_TRUE(stack.messages.empty());
    const glm::dmat4 expected = affine({0.5, 0, 0}, {0, 0.75, 0}, {0, 0, 2.0}, {-10.0, 5.0, 3.0});
    EXPECT_EQ(affineError(*stack.worldFromVoxel, expected), 0.0);
}

TEST(Geometry, SortsAlongTheNormalNotByInstanceNumber) {
    auto planes = evenStack(4, 2.0);
    std::swap(planes[0], planes[2]);
    for (int k = 0; k < 4; ++k) planes[static_cast<std::size_t>(k)].instanceNumber = 100 - k;
    const StackGeometry stack = stackPlanes(planes);
    EXPECT_EQ(stack.order, (std::vector<std::size_t>{2, 1, 0, 3}));
}

TEST(Geometry, SagittalNormalPointsToTheRight) {
    // As in mr_head_sag_hfs: rows run to posterior, columns to inferior, so slices ascend towards the
    // patient's right.
    std::vector<StackedPlane> planes;
    for (int k = 0; k < 3; ++k) {
        planes.push_back({ImagePlane{.positionMm = {-80.0 + 4.8 * k, -130.0, 130.0},
                                     .rowDirection = {0, 1, 0},
                                     .columnDirection = {0, 0, -1}},
                          k});
    }
    const StackGeometry stack = stackPlanes(planes);
    ASSERT_TRUE(stack.worldFromVoxel);
    EXPECT_EQ(stack.order.front(), 2u);
    EXPECT_NEAR((*stack.worldFromVoxel)[2][0], -4.8, 1e-12);
}

TEST(Geometry, TiltedStackStaysSheared) {
    auto planes = evenStack(5, 2.0);
    for (std::size_t k = 0; k < planes.size(); ++k)
        planes[k].plane.positionMm.y += 0.5 * static_cast<double>(k);
    const StackGeometry stack = stackPlanes(planes);
    ASSERT_TRUE(stack.worldFromVoxel);
    EXPECT_EQ(onlyKey(stack), key::kTiltedStack);
    EXPECT_EQ(glm::dvec3((*stack.worldFromVoxel)[2]), glm::dvec3(0, 0.5, 2.0));
}

TEST(Geometry, AGapIsMissingSlicesNotAStretch) {
    auto planes = evenStack(10, 2.0);
    planes.erase(planes.begin() + 4, planes.begin() + 6);
    const StackGeometry stack = stackPlanes(planes);
    EXPECT_EQ(stack.quality, StackGeometry::Quality::resampled);
    EXPECT_TRUE(has(stack, key::kMissingSlices) && has(stack, key::kGapInterpolated));
    EXPECT_NE(stack.messages[0].sentence.english().find("2 of 10"), std::string::npos);
    EXPECT_EQ(glm::dvec3((*stack.worldFromVoxel)[2]), glm::dvec3(0, 0, 2.0));
    ASSERT_EQ(stack.slices.size(), 10u);
    EXPECT_EQ(stack.slices[3], (SliceSource{3, 3, 0.0}));
    EXPECT_EQ(stack.slices[4], (SliceSource{3, 4, 1.0 / 3.0}));
    EXPECT_EQ(stack.slices[5], (SliceSource{3, 4, 2.0 / 3.0}));
    EXPECT_EQ(stack.slices[6], (SliceSource{4, 4, 0.0}));
}

TEST(Geometry, MoreMissingThanThereIsNoVolume) {
    auto planes = evenStack(20, 2.0);
    planes.erase(planes.begin() + 3, planes.begin() + 15);
    const StackGeometry stack = stackPlanes(planes);
    EXPECT_FALSE(stack.worldFromVoxel);
    EXPECT_EQ(onlyKey(stack), key::kMissingSlices);
    EXPECT_EQ(stack.messages[0].severity, Severity::blocksVolume);
}

TEST(Geometry, OneMissingSliceInManyIsSeen) {
    auto planes = evenStack(300, 1.0);
    planes.erase(planes.begin() + 150);
    const StackGeometry stack = stackPlanes(planes);
    EXPECT_TRUE(has(stack, key::kMissingSlices));
    EXPECT_TRUE(stack.slices[150].interpolated());
    EXPECT_EQ(stack.slices.size(), 300u);
}

// At 0, 2, 4, 6, 8 and 11 mm: resampled to the smallest distance, each slice from the two planes around it.
TEST(Geometry, UnevenStepsAreResampledToTheSmallest) {
    auto planes = evenStack(6, 2.0);
    planes[5].plane.positionMm.z += 1.0;
    const StackGeometry stack = stackPlanes(planes);
    EXPECT_TRUE(has(stack, key::kIrregularSpacing) && has(stack, key::kGapInterpolated));
    ASSERT_EQ(stack.slices.size(), 7u);
    for (std::size_t k = 0; k < stack.slices.size(); ++k) {
        const SliceSource& slice = stack.slices[k];
        const auto z = [&](std::size_t place) { return planes[stack.order[place]].plane.positionMm.z; };
        const double drawn = (1.0 - slice.weight) * z(slice.below) + slice.weight * z(slice.above);
        EXPECT_NEAR(drawn, 3.0 + 11.0 / 6.0 * double(k), 1e-9) << k;
    }
}

TEST(Geometry, TwoAlmostEqualPositionsMakeNoHugeVolume) {
    auto planes = evenStack(10, 5.0);
    planes[4].plane.positionMm.z = planes[3].plane.positionMm.z + 0.01;
    const StackGeometry stack = stackPlanes(planes);
    EXPECT_EQ(stack.quality, StackGeometry::Quality::resampled);
    EXPECT_LE(stack.slices.size(), 4u * 9u + 1u);
}

TEST(Geometry, AGapThatIsNoMultipleIsNotFilledWithMeltedSlices) {
    auto planes = evenStack(6, 2.3);
    planes[5].plane.positionMm.z += 1e6;
    const StackGeometry stack = stackPlanes(planes);
    EXPECT_FALSE(stack.worldFromVoxel);
    EXPECT_EQ(onlyKey(stack), key::kSpacingTooIrregular);
}

TEST(Geometry, ASkewedOrientationIsSetRight) {
    auto planes = evenStack(4, 2.0);
    for (auto& p : planes) p.plane.columnDirection = glm::normalize(glm::dvec3(5e-4, 1.0, 0.0));
    const StackGeometry stack = stackPlanes(planes);
    ASSERT_TRUE(stack.worldFromVoxel);
    EXPECT_TRUE(has(stack, key::kRepairedOrientation));
    EXPECT_NEAR(glm::dot((*stack.worldFromVoxel)[0], (*stack.worldFromVoxel)[1]), 0.0, 1e-12);
}

TEST(Geometry, PositionsThatAreNoNumbers) {
    for (const double bad : {double(NAN), double(INFINITY), -double(INFINITY), 1e308}) {
        auto planes = evenStack(4, 2.0);
        planes[1].plane.positionMm.x = bad;
        planes[2].plane.positionMm.z = bad;
        EXPECT_FALSE(stackPlanes(planes).worldFromVoxel) << bad;
    }
    EXPECT_TRUE(stackPlanes({}).order.empty());
}

// Found by fuzz_series: the slices between lost their place beside a distance of 1e92 mm.
TEST(Geometry, PositionsAndSpacingsNoPatientCanHave) {
    const auto makesVolume = [](auto change) {
        auto planes = evenStack(4, 2.0);
        for (auto& p : planes) change(p.plane);
        return stackPlanes(planes).worldFromVoxel.has_value();
    };
    EXPECT_TRUE(makesVolume([](ImagePlane& p) { p.positionMm.x += 1e5; }));
    EXPECT_FALSE(makesVolume([](ImagePlane& p) { p.positionMm.x -= 5.6e92; }));
    EXPECT_FALSE(makesVolume([](ImagePlane& p) { p.positionMm.z *= 1e9; }));
    EXPECT_TRUE(makesVolume([](ImagePlane& p) { p.rowSpacingMm = 2.5e-4; }));
    EXPECT_FALSE(makesVolume([](ImagePlane& p) { p.rowSpacingMm = 1e-300; }));
    EXPECT_FALSE(makesVolume([](ImagePlane& p) { p.columnSpacingMm = 1e9; }));
}

// Found by fuzz_series: the last slice was the plane before the last.
TEST(Geometry, OfTwoPlanesThatLieCloseTheNearerIsTheSlice) {
    auto planes = evenStack(3, 240.0);
    planes[2].plane.positionMm.z = planes[1].plane.positionMm.z + 0.3;
    const StackGeometry stack = stackPlanes(planes);
    ASSERT_TRUE(stack.worldFromVoxel);
    EXPECT_EQ(stack.slices.front().below, 0u);
    EXPECT_EQ(stack.slices.back(), (SliceSource{2, 2, 0.0}));
}

// Found by fuzz_series: a volume whose slices go along its rows.
TEST(Geometry, SlicesBesideEachOther) {
    auto planes = evenStack(4, 0.01);
    for (std::size_t k = 0; k < planes.size(); ++k) planes[k].plane.positionMm.x = 1e5 * double(k);
    const StackGeometry stack = stackPlanes(planes);
    EXPECT_FALSE(stack.worldFromVoxel);
    EXPECT_EQ(onlyKey(stack), key::kNotReconstructable);
    EXPECT_TRUE(stack.slices.empty());
}

TEST(Geometry, ASlowDriftOfTheStepIsSeenToo) {
    auto planes = evenStack(100, 2.0);
    for (std::size_t k = 0; k < planes.size(); ++k) {
        planes[k].plane.positionMm.z +=
            0.0005 * static_cast<double>(k * k);  // no step is far from its neighbours
    }
    const StackGeometry stack = stackPlanes(planes);
    EXPECT_TRUE(has(stack, key::kIrregularSpacing));
}

TEST(Geometry, SmallUnevennessIsToldWithItsSize) {
    auto planes = evenStack(6, 1.0);
    planes[3].plane.positionMm.z += 0.05;
    const StackGeometry stack = stackPlanes(planes);
    ASSERT_TRUE(stack.worldFromVoxel);
    EXPECT_EQ(onlyKey(stack), key::kUnevenSpacing);
    EXPECT_NEAR(stack.largestErrorMm, 0.05, 1e-12);
}

TEST(Geometry, DecimalNoiseIsNoUnevenness) {
    auto planes = evenStack(50, 1.25);
    for (auto& p : planes) p.plane.positionMm.z = std::round(p.plane.positionMm.z * 1000.0) / 1000.0;
    EXPECT_TRUE(stackPlanes(planes).messages.empty());
}

TEST(Geometry, SlicesShiftedSideways) {
    auto planes = evenStack(6, 2.0);
    planes[3].plane.positionMm.x += 3.0;
    EXPECT_EQ(onlyKey(stackPlanes(planes)), key::kNotReconstructable);
}

// Slices that drift off their line, as those of a patient who breathes: up to a tenth of their distance. A
// drift in one direction is a tilted gantry, however far it goes.
TEST(Geometry, SlicesDriftSidewaysByATenthOfTheirDistance) {
    const auto drifted = [](double mm) {
        auto planes = evenStack(7, 2.0);
        for (int k = 0; k < 7; ++k) {
            planes[std::size_t(k)].plane.positionMm.x += 0.5 * k;
            planes[std::size_t(k)].plane.positionMm.y += mm * (1.0 - std::abs(k - 3) / 3.0);
        }
        return stackPlanes(planes);
    };
    EXPECT_TRUE(drifted(0.19).worldFromVoxel);
    EXPECT_FALSE(drifted(0.21).worldFromVoxel);
    EXPECT_TRUE(has(drifted(0.21), key::kNotReconstructable));
    EXPECT_FALSE(drifted(-0.21).worldFromVoxel);
}

TEST(Geometry, DuplicatePositionsAreOrderedByInstanceNumberAndRefused) {
    auto planes = evenStack(4, 2.0);
    planes[1].plane.positionMm = planes[0].plane.positionMm;
    planes[0].instanceNumber = 9;
    const StackGeometry stack = stackPlanes(planes);
    EXPECT_EQ(onlyKey(stack), key::kDuplicatePositions);
    EXPECT_EQ(stack.order[0], 1u);
}

TEST(Geometry, DifferingOrientationSpacingAndBadDirections) {
    auto planes = evenStack(4, 2.0);
    planes[2].plane.rowDirection = {0, 1, 0};
    planes[2].plane.columnDirection = {0, 0, -1};
    EXPECT_EQ(onlyKey(stackPlanes(planes)), key::kNotParallel);
    planes = evenStack(4, 2.0);
    planes[2].plane.rowSpacingMm = 0.8;
    EXPECT_EQ(onlyKey(stackPlanes(planes)), key::kNotReconstructable);
    planes = evenStack(4, 2.0);
    planes[2].plane.rowDirection = {1, 1, 0};
    EXPECT_EQ(onlyKey(stackPlanes(planes)), key::kInvalidOrientation);
    EXPECT_EQ(onlyKey(stackPlanes(evenStack(1, 2.0))), key::kSingleSlice);
}

}  // namespace
}  // namespace macula::dicom::test
