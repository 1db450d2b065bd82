#include "dicom/intensity.h"

#include <gtest/gtest.h>

#include <array>

namespace macula::dicom {
namespace {

std::vector<std::uint16_t> unpacked(const CellFormat& format, std::vector<std::uint16_t> cells) {
    unpackCells(format, cells);
    return cells;
}

double valueOf(const IntensityPlan& plan, std::size_t slice, std::uint16_t unpackedValue) {
    std::array<std::uint16_t, 1> voxel{unpackedValue};
    applyMap(plan.slices[slice], voxel);
    return plan.unitsFromStored(voxel[0]);
}

TEST(Intensity, unsignedTwelveBitsDropsOverlayBits) {
    EXPECT_EQ(unpacked({16, 12, 11, false}, {0x0FFF, 0xF123, 0x0000}),
              (std::vector<std::uint16_t>{0x0FFF, 0x0123, 0}));
}

TEST(Intensity, storedBitsMayBeHigh) {
    EXPECT_EQ(unpacked({16, 12, 15, false}, {0xABCF}), (std::vector<std::uint16_t>{0x0ABC}));
}

TEST(Intensity, signExtension) {
    EXPECT_EQ(unpacked({16, 12, 11, true}, {0x0FFF, 0x0800, 0x07FF, 0xF000}),
              (std::vector<std::uint16_t>{32767, 32768 - 2048, 32768 + 2047, 32768}));
    EXPECT_EQ(unpacked({16, 16, 15, true}, {0x8000, 0xFFFF, 0x7FFF}),
              (std::vector<std::uint16_t>{0, 32767, 65535}));
    EXPECT_EQ(unpacked({8, 8, 7, true}, {0xFF, 0x7F}), (std::vector<std::uint16_t>{32767, 32768 + 127}));
}

TEST(Intensity, formatsThatMakeNoSense) {
    EXPECT_TRUE(isUsable({16, 16, 15, true}));
    EXPECT_TRUE(isUsable({8, 8, 7, false}));
    EXPECT_FALSE(isUsable({1, 1, 0, false}));
    EXPECT_FALSE(isUsable({32, 32, 31, false}));
    EXPECT_FALSE(isUsable({16, 12, 16, false}));
    EXPECT_FALSE(isUsable({16, 12, 10, false}));
    EXPECT_FALSE(isUsable({16, 0, -1, false}));
}

TEST(Intensity, paddingWordsAreReadWithThePixelsSign) {
    EXPECT_EQ(paddingRange({16, 16, 15, true}, 0xF830, {}), (RawRange{-2000, -2000}));
    EXPECT_EQ(paddingRange({16, 16, 15, false}, 0xF830, {}), (RawRange{63536, 63536}));
    EXPECT_EQ(paddingRange({16, 16, 15, true}, 0, std::uint16_t{0xFFF0}), (RawRange{-16, 0}));
}

TEST(Intensity, signedCtIsExact) {
    const std::vector<SliceIntensity> slices(
        3, {.format = {}, .slope = 1.0, .intercept = -1024.0, .padding = {}});
    std::vector<SliceIntensity> signedSlices = slices;
    for (auto& s : signedSlices) {
        s.format.isSigned = true;
        s.padding = RawRange{-2000, -2000};
    }
    ASSERT_TRUE(isUniform(signedSlices));
    const IntensityPlan plan = uniformPlan(signedSlices);
    EXPECT_EQ(valueOf(plan, 0, 32768), -1024.0);
    EXPECT_EQ(valueOf(plan, 2, 65535), 31743.0);
    ASSERT_TRUE(plan.padding);
    EXPECT_EQ(plan.unitsFromStored(plan.padding->low), -3024.0);
    EXPECT_TRUE(plan.assumptions.empty());
}

TEST(Intensity, negativeSlopeIsExactAndKeepsThePositiveSlopeOfTheVolume) {
    const std::vector<SliceIntensity> slices(
        2, {.format = {}, .slope = -2.0, .intercept = 100.0, .padding = RawRange{7, 9}});
    const IntensityPlan plan = uniformPlan(slices);
    EXPECT_GT(plan.unitsFromStored.slope, 0.0);
    for (const std::uint16_t raw : {0, 1, 8, 40000, 65535})
        EXPECT_EQ(valueOf(plan, 1, raw), 100.0 - 2.0 * raw);
    ASSERT_TRUE(plan.padding);
    EXPECT_EQ(plan.unitsFromStored(plan.padding->low), 100.0 - 2.0 * 9);
    EXPECT_EQ(plan.unitsFromStored(plan.padding->high), 100.0 - 2.0 * 7);
}

TEST(Intensity, paddingThatTheSlicesDisagreeOn) {
    std::vector<SliceIntensity> slices(2);
    slices[0].padding = RawRange{0, 0};
    const IntensityPlan some = uniformPlan(slices);
    EXPECT_TRUE(some.padding);
    EXPECT_EQ(some.assumptions.size(), 1u);
    slices[1].padding = RawRange{5, 5};
    const IntensityPlan differ = uniformPlan(slices);
    EXPECT_FALSE(differ.padding);
    EXPECT_EQ(differ.assumptions.size(), 1u);
}

TEST(Intensity, paddingOutsideTheStoredBitsIsNone) {
    std::vector<SliceIntensity> slices(2);
    for (auto& s : slices) {
        s.format = {16, 12, 11, false};
        s.padding = RawRange{63536, 63536};
    }
    const IntensityPlan plan = uniformPlan(slices);
    EXPECT_FALSE(plan.padding);
    EXPECT_EQ(plan.assumptions.size(), 1u);
}

TEST(Intensity, mixedSlopesWithACommonStepAreExact) {
    std::vector<SliceIntensity> slices(3);
    slices[0] = {.format = {}, .slope = 0.5, .intercept = -10.0, .padding = {}};
    slices[1] = {.format = {}, .slope = 1.5, .intercept = 4.0, .padding = {}};
    slices[2] = {.format = {16, 12, 11, true}, .slope = -1.0, .intercept = 0.0, .padding = {}};
    EXPECT_FALSE(isUniform(slices));
    const IntensityPlan plan =
        mixedPlan(slices, std::vector<StoredRange>{{0, 4000}, {10, 3000}, {32768 - 2048, 32768 + 2047}});
    EXPECT_TRUE(plan.assumptions.empty());
    EXPECT_EQ(valueOf(plan, 0, 3999), 0.5 * 3999 - 10.0);
    EXPECT_EQ(valueOf(plan, 1, 2999), 1.5 * 2999 + 4.0);
    EXPECT_EQ(valueOf(plan, 2, 32768 - 2000), 2000.0);
}

TEST(Intensity, mixedSlopesWithoutACommonStepStateTheirError) {
    std::vector<SliceIntensity> slices(2);
    slices[0] = {.format = {}, .slope = 0.0123, .intercept = 0.0, .padding = {}};
    slices[1] = {.format = {}, .slope = 0.0347, .intercept = 0.0, .padding = RawRange{0, 0}};
    const IntensityPlan plan = mixedPlan(slices, std::vector<StoredRange>{{0, 60000}, {1, 50000}});
    ASSERT_EQ(plan.assumptions.size(), 2u);
    EXPECT_NE(plan.assumptions[0].find("error of at most"), std::string::npos);
    const double bound = 0.5 * (0.0347 * 50000) / 65534.0 * (1.0 + 1e-9);
    for (const std::uint16_t raw : {1, 777, 31415, 50000}) {
        EXPECT_NEAR(valueOf(plan, 0, raw), 0.0123 * raw, bound);
        EXPECT_NEAR(valueOf(plan, 1, raw), 0.0347 * raw, bound);
    }
    // Padding of the second slice is apart from the true 0 of the first.
    std::array<std::uint16_t, 1> padding{0};
    applyMap(plan.slices[1], padding);
    EXPECT_TRUE(plan.padding->contains(padding[0]));
    std::array<std::uint16_t, 1> zero{0};
    applyMap(plan.slices[0], zero);
    EXPECT_FALSE(plan.padding->contains(zero[0]));
}

}  // namespace
}  // namespace macula::dicom
