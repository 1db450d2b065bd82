// D4: slices that are missing, or not evenly spaced.
#include <cmath>

#include "opened.h"

namespace macula::dicom::test {
namespace {

using D04Gaps = Pitfall;

TEST_F(D04Gaps, MissingSlicesAreInterpolatedAndSaid) {
    auto slices = slicesOf(series);
    slices.erase(slices.begin() + 7, slices.begin() + 9);
    slices.erase(slices.begin() + 3);
    writeFiles(folder.path(), series, slices);
    const Opened opened = open();
    const auto volume = opened.onlyVolume();
    ASSERT_NE(volume, nullptr);
    expectVolumeOf(*volume, series);
    const Message* missing = opened.find(key::kMissingSlices);
    ASSERT_NE(missing, nullptr) << opened.keys();
    EXPECT_EQ(numberArgument(*missing, "missing"), 3.0);
    EXPECT_EQ(numberArgument(*missing, "total"), 12.0);
    EXPECT_NEAR(numberArgument(*missing, "spacingMm"), 2.3, 1e-6);
    EXPECT_TRUE(opened.says(key::kGapInterpolated)) << opened.keys();
    EXPECT_EQ(volume->provenance().interpolatedSlices, (std::vector<SliceRange>{{3, 3}, {7, 8}}));
}

TEST_F(D04Gaps, WithoutGapsNothingIsInterpolated) {
    writeFiles(folder.path(), series);
    const Opened opened = open();
    const auto volume = opened.onlyVolume();
    ASSERT_NE(volume, nullptr);
    EXPECT_TRUE(volume->provenance().interpolatedSlices.empty());
    EXPECT_FALSE(opened.says(key::kMissingSlices));
    EXPECT_FALSE(opened.says(key::kGapInterpolated));
    EXPECT_FALSE(opened.says(key::kIrregularSpacing));
    EXPECT_FALSE(opened.says(key::kUnevenSpacing));
}

// Every other slice is a spacing of its own, and no gap.
TEST_F(D04Gaps, TwiceTheDistanceIsNoGap) {
    series.places = {0, 2, 4, 6, 8, 10};
    writeFiles(folder.path(), series);
    const Opened opened = open();
    const auto volume = opened.onlyVolume();
    ASSERT_NE(volume, nullptr);
    EXPECT_EQ(volume->size().z, 6);
    EXPECT_FALSE(opened.says(key::kMissingSlices));
    expectRamp(*volume, series.rampOf());
}

// What is interpolated between even positions is no longer what was measured, but on a linear ramp it is.
TEST_F(D04Gaps, IrregularSpacingIsResampledEvenly) {
    series.places = {0, 1, 2.4, 3.1, 4.5, 5, 6.2, 7, 8.7, 9.5, 10, 11};
    writeFiles(folder.path(), series);
    const Opened opened = open();
    const auto volume = opened.onlyVolume();
    ASSERT_NE(volume, nullptr);
    const Message* told = opened.find(key::kIrregularSpacing);
    ASSERT_NE(told, nullptr) << opened.keys();
    EXPECT_NEAR(numberArgument(*told, "leastMm"), 0.5 * 2.3, 1e-6);
    EXPECT_NEAR(numberArgument(*told, "mostMm"), 1.7 * 2.3, 1e-6);
    expectRamp(*volume, series.rampOf(), 1.0);
    // From the first slice to the last, no coarser than the usual step.
    const glm::dvec3 first = transformPoint(volume->worldFromVoxel(), {0, 0, 0});
    const glm::dvec3 last = transformPoint(volume->worldFromVoxel(), {0, 0, volume->size().z - 1});
    EXPECT_LT(glm::length(first - transformPoint(series.worldFromVoxel, {0, 0, 0})), 1e-4);
    const double short_ = glm::length(last - transformPoint(series.worldFromVoxel, {0, 0, 11}));
    EXPECT_LT(short_, volume->spacingMm().z);
    EXPECT_LE(volume->spacingMm().z, 2.3 + 1e-6);
    EXPECT_FALSE(volume->provenance().interpolatedSlices.empty());
}

// Two spacings in one series, as in a chest with thin slices in the middle.
TEST_F(D04Gaps, ThinSlicesInTheMiddle) {
    series.places = {0, 2, 4, 5, 6, 7, 8, 9, 11};
    writeFiles(folder.path(), series);
    const Opened opened = open();
    const auto volume = opened.onlyVolume();
    ASSERT_NE(volume, nullptr);
    expectVolumeOf(*volume, series);
}

// A slice may be away from where it is drawn by what the message says, and no more.
TEST_F(D04Gaps, SmallUnevennessIsToldWithItsSize) {
    series.places = {0, 1, 2.03, 3, 3.97, 5, 6, 7.03, 8, 9, 10, 11};
    const auto slices = slicesOf(series);
    writeFiles(folder.path(), series, slices);
    const Opened opened = open();
    const auto volume = opened.onlyVolume();
    ASSERT_NE(volume, nullptr);
    double allowed = 0.0;
    if (const Message* told = opened.find(key::kUnevenSpacing)) {
        allowed = numberArgument(*told, "errorMm");
        EXPECT_NEAR(allowed, 0.03 * 2.3, 1e-4);
    } else {
        EXPECT_TRUE(opened.says(key::kIrregularSpacing)) << opened.keys();
    }
    // The steepest the ramp can be.
    expectRamp(*volume, series.rampOf(), 0.5 + allowed * glm::length(series.rampOf().perMm));
}

// Scanners round positions to a few digits: a tenth of a percent is noise.
TEST_F(D04Gaps, RoundedPositionsAreNotUneven) {
    auto slices = slicesOf(series);
    for (Slice& slice : slices) slice.positionMm = glm::round(slice.positionMm * 1e3) * 1e-3;
    writeFiles(folder.path(), series, slices);
    const Opened opened = open();
    const auto volume = opened.onlyVolume();
    ASSERT_NE(volume, nullptr);
    EXPECT_FALSE(opened.says(key::kUnevenSpacing)) << opened.keys();
    EXPECT_FALSE(opened.says(key::kIrregularSpacing)) << opened.keys();
    expectGrid(*volume, series.size, series.expectedAffine(), 1e-3);
    expectRamp(*volume, series.rampOf(), 0.5 + 1e-3 * glm::length(series.rampOf().perMm));
}

// Head and pelvis in one series: nearly all of the volume would be made up. Whatever becomes of it, it is
// said, and it costs no memory to speak of.
TEST_F(D04Gaps, AGapOfAKilometreIsNotFilled) {
    series.places = {0, 1, 2, 3, 4, 5};
    auto slices = slicesOf(series);
    slices.back().positionMm += 1e6 * slices.back().normal();
    series.rawInstead = [](const Slice&, int i, int j) { return i + j; };
    writeFiles(folder.path(), series, slices);
    const Opened opened = open();
    EXPECT_EQ(opened.frames(), 6u);
    EXPECT_FALSE(opened.messages().empty());
    for (const Stack* stack : opened.volumes()) {
        EXPECT_LE(stack->slices.size(), 60u);
        ASSERT_TRUE(stack->spacingMm);
        EXPECT_NEAR(stack->spacingMm->z, 2.3, 0.03) << "slices were melted into a coarser grid";
        EXPECT_NE(opened.load(*stack), nullptr);
    }
}

// Values are interpolated, not stored numbers: each slice has its own slope.
TEST_F(D04Gaps, BetweenSlicesOfDifferentSlopes) {
    series.modality = "PT";
    auto slices = slicesOf(series);
    for (Slice& slice : slices) {
        slice.slope = 0.1 * (1 + slice.place % 4);
        slice.intercept = 1000.0;
    }
    slices.erase(slices.begin() + 6);
    writeFiles(folder.path(), series, slices);
    const auto volume = open().onlyVolume();
    ASSERT_NE(volume, nullptr);
    expectGrid(*volume, series.size, series.expectedAffine());
    expectRamp(*volume, series.rampOf(), 0.2);
}

TEST_F(D04Gaps, HeadAndPelvisAreTwoBlocks) {
    series.places = {0, 1, 2, 3, 4, 5, 130.4, 131.4, 132.4, 133.4, 134.4, 135.4};
    series.ramp =
        Ramp{.value = 2000, .throughMm = glm::dvec3(series.worldFromVoxel[3]), .perMm = {11, 23, 17}};
    writeFiles(folder.path(), series);
    const Opened opened = open();
    EXPECT_EQ(opened.frames(), 12u);
    for (const Stack* stack : opened.volumes()) {
        const auto volume = opened.load(*stack);
        ASSERT_NE(volume, nullptr);
        EXPECT_EQ(volume->size().z, 6);
        EXPECT_NEAR(volume->spacingMm().z, 2.3, 1e-3);
        expectRamp(*volume, *series.ramp);
    }
    EXPECT_TRUE(opened.says(key::kSeparateBlocks)) << opened.keys();
}

// The coarse picture of a stack with a gap must not differ from the fine one's geometry: every slice of the
// grid names the frames it is made of.
TEST_F(D04Gaps, GridNamesItsFrames) {
    auto slices = slicesOf(series);
    slices.erase(slices.begin() + 3);
    writeFiles(folder.path(), series, slices);
    const Opened opened = open();
    ASSERT_EQ(opened.volumes().size(), 1u);
    const Stack& stack = *opened.volumes()[0];
    ASSERT_EQ(stack.slices.size(), 12u);
    for (std::size_t k = 0; k < 12; ++k) {
        SCOPED_TRACE(k);
        const SliceSource& source = stack.slices[k];
        const std::size_t frame = k < 3 ? k : k - 1;
        if (k == 3) {
            EXPECT_EQ(source.below, 2u);
            EXPECT_EQ(source.above, 3u);
            EXPECT_NEAR(source.weight, 0.5, 1e-6);
        } else {
            EXPECT_EQ(source.below, frame);
            EXPECT_EQ(source.above, frame);
        }
    }
}

}  // namespace
}  // namespace macula::dicom::test
