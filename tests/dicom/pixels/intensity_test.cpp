#include "dicom/stack/intensity.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace macula::dicom {
namespace {

std::vector<std::uint16_t> unpacked(const CellFormat& format, std::vector<std::uint16_t> cells,
                                    std::optional<RawRange> padding = {}) {
    unpackCells(format, padding, cells);
    return cells;
}

IntensityPlan planOf(const std::vector<SliceIntensity>& slices) {
    return planFromFormats(slices);
}

SliceIntensity slice(double slope, double intercept, CellFormat format = {},
                     std::optional<RawRange> padding = {}) {
    return {.format = format, .slope = slope, .intercept = intercept, .padding = padding};
}

constexpr CellFormat kTwelveBits{16, 12, 11, false};
constexpr CellFormat kSignedTwelveBits{16, 12, 11, true};

double valueOf(const IntensityPlan& plan, std::size_t slice, std::uint16_t unpackedValue) {
    std::array<std::uint16_t, 1> voxel{unpackedValue};
    applyMap(plan.slices[slice], voxel);
    return plan.unitsFromStored(voxel[0]);
}

TEST(Intensity, UnsignedTwelveBitsDropsOverlayBits) {
    EXPECT_EQ(unpacked({16, 12, 11, false}, {0x0FFF, 0xF123, 0x0000}),
              (std::vector<std::uint16_t>{0x0FFF, 0x0123, 0}));
}

TEST(Intensity, StoredBitsMayBeHigh) {
    EXPECT_EQ(unpacked({16, 12, 15, false}, {0xABCF}), (std::vector<std::uint16_t>{0x0ABC}));
}

TEST(Intensity, SignExtension) {
    EXPECT_EQ(unpacked({16, 12, 11, true}, {0x0FFF, 0x0800, 0x07FF, 0xF000}),
              (std::vector<std::uint16_t>{32767, 32768 - 2048, 32768 + 2047, 32768}));
    EXPECT_EQ(unpacked({16, 16, 15, true}, {0x8000, 0xFFFF, 0x7FFF}),
              (std::vector<std::uint16_t>{0, 32767, 65535}));
    EXPECT_EQ(unpacked({8, 8, 7, true}, {0xFF, 0x7F}), (std::vector<std::uint16_t>{32767, 32768 + 127}));
}

TEST(Intensity, FormatsThatMakeNoSense) {
    EXPECT_TRUE(isUsable({16, 16, 15, true}));
    EXPECT_TRUE(isUsable({8, 8, 7, false}));
    EXPECT_TRUE(isUsable({1, 1, 0, false}));
    EXPECT_TRUE(isUsable({32, 32, 31, false}));
    EXPECT_TRUE(isUsable(floatFormat(CellKind::float32)));
    EXPECT_TRUE(isUsable(floatFormat(CellKind::float64)));
    EXPECT_FALSE(isUsable({64, 64, 63, false}));
    EXPECT_FALSE(isUsable({12, 12, 11, false}));
    EXPECT_FALSE(isUsable({1, 8, 7, false}));
    EXPECT_FALSE(isUsable({16, 16, 15, true, CellKind::float32}));
    EXPECT_FALSE(isUsable({16, 12, 16, false}));
    EXPECT_FALSE(isUsable({16, 12, 10, false}));
    EXPECT_FALSE(isUsable({16, 0, -1, false}));
}

TEST(Intensity, PaddingWordsAreReadWithThePixelsSign) {
    EXPECT_EQ(paddingRange({16, 16, 15, true}, 0xF830, {}), (RawRange{-2000, -2000}));
    EXPECT_EQ(paddingRange({16, 16, 15, false}, 0xF830, {}), (RawRange{63536, 63536}));
    EXPECT_EQ(paddingRange({16, 16, 15, true}, 0, std::uint16_t{0xFFF0}), (RawRange{-16, 0}));
}

TEST(Intensity, SignedCtIsExact) {
    const IntensityPlan plan =
        planOf(std::vector(3, slice(1.0, -1024.0, {16, 16, 15, true}, RawRange{-2000, -2000})));
    EXPECT_EQ(plan.format, VoxelFormat::stored16);
    EXPECT_EQ(valueOf(plan, 0, 32768), -1024.0);
    EXPECT_EQ(valueOf(plan, 2, 65535), 31743.0);
    ASSERT_TRUE(plan.padding);
    EXPECT_EQ(plan.unitsFromStored(plan.padding->low), -3024.0);
}

TEST(Intensity, NegativeSlopeIsExactAndKeepsThePositiveSlopeOfTheVolume) {
    const IntensityPlan plan = planOf(std::vector(2, slice(-2.0, 100.0, {}, RawRange{7, 9})));
    EXPECT_GT(plan.unitsFromStored.slope, 0.0);
    for (const std::uint16_t raw : {0, 1, 8, 40000, 65535})
        EXPECT_EQ(valueOf(plan, 1, raw), 100.0 - 2.0 * raw);
    ASSERT_TRUE(plan.padding);
    EXPECT_EQ(plan.unitsFromStored(plan.padding->low), 100.0 - 2.0 * 9);
    EXPECT_EQ(plan.unitsFromStored(plan.padding->high), 100.0 - 2.0 * 7);
}

TEST(Intensity, SlicesWithoutPaddingGetThatOfTheOthersAndSaySo) {
    std::vector<SliceIntensity> slices(3);
    EXPECT_FALSE(completePadding(slices));
    slices[0].padding = RawRange{0, 0};
    const auto said = completePadding(slices);
    ASSERT_TRUE(said);
    EXPECT_NE(said->english().find("2 of 3"), std::string::npos);
    EXPECT_EQ(slices[2].padding, (RawRange{0, 0}));
    EXPECT_FALSE(completePadding(slices));
    slices[1].padding = RawRange{5, 5};
    slices[2].padding.reset();
    EXPECT_FALSE(completePadding(slices));
    EXPECT_FALSE(slices[2].padding);
}

// Each slice's own padding, and only that, is padding; a true 5 of the first and 0 of the second are not.
TEST(Intensity, SlicesMayDisagreeOnPadding) {
    const std::vector<SliceIntensity> slices{slice(1.0, 0.0, kTwelveBits, RawRange{0, 0}),
                                             slice(1.0, 0.0, kTwelveBits, RawRange{5, 5}),
                                             slice(1.0, 0.0, kTwelveBits)};
    const IntensityPlan plan = planOf(slices);
    ASSERT_EQ(plan.format, VoxelFormat::stored16);
    ASSERT_TRUE(plan.padding);
    for (std::size_t k = 0; k < 3; ++k) {
        for (const std::uint16_t raw : {0, 5, 4095}) {
            std::array<std::uint16_t, 1> voxel{raw};
            applyMap(plan.slices[k], voxel);
            const bool isPadding = (k == 0 && raw == 0) || (k == 1 && raw == 5);
            EXPECT_EQ(plan.padding->contains(voxel[0]), isPadding) << k << " " << raw;
            if (!isPadding) {
                EXPECT_EQ(plan.unitsFromStored(voxel[0]), raw);
            }
        }
    }
}

// Pitfall D11: unsigned, 12 bits stored, and -2000 as the padding word.
TEST(Intensity, PaddingThatTheStoredBitsCannotHoldIsRecognisedBeforeMasking) {
    const RawRange padding = paddingRange(kTwelveBits, 63536, {});
    EXPECT_EQ(unpacked(kTwelveBits, {63536, 0x0830, 0xF831, 7}, padding),
              (std::vector<std::uint16_t>{63536, 0x0830, 0x0831, 7}));
    const std::vector<SliceIntensity> slices(2, slice(1.0, -1024.0, kTwelveBits, padding));
    const IntensityPlan plan = planOf(slices);
    ASSERT_TRUE(plan.padding);
    EXPECT_TRUE(plan.padding->contains(63536));
    EXPECT_FALSE(plan.padding->contains(0x0830));
    // Of signed cells: the whole word, also where the sign bit of the stored bits says otherwise.
    const RawRange positive = paddingRange(kSignedTwelveBits, 0x0830, {});
    EXPECT_EQ(unpacked(kSignedTwelveBits, {0x0830, 0xF830, 1}, positive),
              (std::vector<std::uint16_t>{32768 + 0x0830, 32768 - 2000, 32769}));
    EXPECT_EQ(unpackedPadding({.format = kSignedTwelveBits, .padding = positive}),
              (StoredRange{32768 + 0x0830, 32768 + 0x0830}));
}

// An overlay in the bits above: only the stored bits count.
TEST(Intensity, PaddingThatTheStoredBitsHoldIsRecognisedAfterMasking) {
    const RawRange padding{0, 3};
    const auto cells = unpacked(kTwelveBits, {0xF000, 0x1003, 0x1004}, padding);
    EXPECT_EQ(cells, (std::vector<std::uint16_t>{0, 3, 4}));
    const CellFormat high{16, 12, 15, false};
    EXPECT_EQ(unpacked(high, {0xF830}, RawRange{63536, 63536}), (std::vector<std::uint16_t>{0x0F83}));
}

TEST(Intensity, MixedSlopesWithACommonStepAreExactIn16Bits) {
    const std::vector<SliceIntensity> slices{slice(0.5, -10.0, kTwelveBits), slice(0.75, 4.0, kTwelveBits),
                                             slice(-1.0, 0.0, kSignedTwelveBits)};
    const IntensityPlan plan = planOf(slices);
    ASSERT_EQ(plan.format, VoxelFormat::stored16);
    EXPECT_EQ(plan.unitsFromStored.slope, 0.25);
    for (const std::uint16_t raw : {0, 1, 2999, 4095}) {
        EXPECT_EQ(valueOf(plan, 0, raw), 0.5 * raw - 10.0);
        EXPECT_EQ(valueOf(plan, 1, raw), 0.75 * raw + 4.0);
    }
    EXPECT_EQ(valueOf(plan, 2, 32768 - 2000), 2000.0);
    EXPECT_EQ(valueOf(plan, 2, 32768 + 2047), -2047.0);
}

TEST(Intensity, DecimalSlopesShareTheirLastDigit) {
    const std::vector<SliceIntensity> slices{slice(0.1, 0.0, kTwelveBits), slice(0.3, -0.7, kTwelveBits)};
    const IntensityPlan plan = planOf(slices);
    ASSERT_EQ(plan.format, VoxelFormat::stored16);
    for (const std::uint16_t raw : {0, 1, 777, 4095}) {
        EXPECT_EQ(static_cast<float>(valueOf(plan, 0, raw)), static_cast<float>(0.1 * raw));
        EXPECT_EQ(static_cast<float>(valueOf(plan, 1, raw)), static_cast<float>(0.3 * raw - 0.7));
    }
}

TEST(Intensity, WhereTheFormatsDoNotTellThePixelsDo) {
    const IntensityPlan plan = planOf({slice(1.0, 0.0), slice(2.0, -0.5, {}, RawRange{0, 0})});
    ASSERT_EQ(plan.format, VoxelFormat::float32);
    ASSERT_TRUE(plan.steps);
    EXPECT_EQ(plan.steps->slope, 0.5);
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    const auto enough = narrowed(std::vector<float>{3.0F, kNan, -0.5F, 32766.0F}, *plan.steps);
    ASSERT_TRUE(enough);
    ASSERT_TRUE(enough->padding);
    EXPECT_TRUE(enough->padding->contains(enough->voxels[1]));
    EXPECT_FALSE(enough->padding->contains(enough->voxels[2]));
    for (const auto& [i, value] : {std::pair(0u, 3.0), std::pair(2u, -0.5), std::pair(3u, 32766.0)})
        EXPECT_EQ(enough->unitsFromStored(enough->voxels[i]), value);
    EXPECT_FALSE(narrowed(std::vector<float>{kNan, -0.5F, 32767.0F}, *plan.steps));  // one step too many
    EXPECT_TRUE(narrowed(std::vector<float>{-0.5F, 32767.0F}, *plan.steps));
    EXPECT_FALSE(narrowed(std::vector<float>{-0.5F, 1.25F}, *plan.steps));  // between two steps
    EXPECT_TRUE(narrowed(std::vector<float>{kNan, kNan}, *plan.steps));
}

TEST(Intensity, WideIntegersMayFit16BitsAfterAll) {
    const IntensityPlan plan = planOf(std::vector(2, slice(0.5, -7.0, {32, 32, 31, true})));
    ASSERT_EQ(plan.format, VoxelFormat::float32);
    ASSERT_TRUE(plan.steps);
    const auto narrow = narrowed(std::vector<float>{0.5F * -3 - 7, 0.5F * 60000 - 7}, *plan.steps);
    ASSERT_TRUE(narrow);
    EXPECT_EQ(narrow->unitsFromStored(narrow->voxels[1]), 0.5 * 60000 - 7);
}

// Float has rounded them already; 16 bits with a step of 1 would look exact.
TEST(Intensity, IntegersThatFloatCannotHoldStayFloat) {
    const IntensityPlan plan = planOf(std::vector(2, slice(1.0, 0.0, {32, 32, 31, false})));
    ASSERT_TRUE(plan.steps);
    constexpr float kLast = 1 << 24;
    EXPECT_TRUE(narrowed(std::vector<float>{kLast - 2, kLast}, *plan.steps));
    EXPECT_FALSE(narrowed(std::vector<float>{kLast, kLast + 2}, *plan.steps));
}

TEST(Intensity, NarrowingManyPortionsAndCancelling) {
    const UnitsFromStored steps{0.5, -3.0};
    std::vector<float> values(3'000'000);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = 0.5F * static_cast<float>(i % 50'000);
    values[2'999'999] = std::numeric_limits<float>::quiet_NaN();
    const auto narrow = narrowed(values, steps);
    ASSERT_TRUE(narrow);
    EXPECT_TRUE(narrow->padding->contains(narrow->voxels.back()));
    for (std::size_t i = 0; i + 1 < values.size(); ++i)
        ASSERT_EQ(narrow->unitsFromStored(narrow->voxels[i]), values[i]) << i;
    values[2'500'000] = 0.25F;
    EXPECT_FALSE(narrowed(values, steps));
    values[2'500'000] = 0.5F;
    CancelToken cancel;
    cancel.cancel();
    EXPECT_FALSE(narrowed(values, steps, cancel));
}

TEST(Intensity, MixedSlopesWithoutACommonStepNeedFloat) {
    EXPECT_EQ(planOf({slice(0.0123457, 0.0), slice(0.0346987, 0.0)}).format, VoxelFormat::float32);
    EXPECT_FALSE(planOf({slice(0.0123457, 0.0), slice(0.0346987, 0.0)}).steps);
    EXPECT_EQ(planOf({slice(1e300, 0.0), slice(1e-300, 1e300)}).format, VoxelFormat::float32);
    EXPECT_EQ(planOf({slice(1.0, 0.0), slice(1.0, 1e18)}).format, VoxelFormat::float32);
}

TEST(Intensity, FloatValuesAreComputedInDouble) {
    SliceIntensity s = slice(0.0123457, -3.25, kSignedTwelveBits, RawRange{-2000, -1990});
    const std::vector<std::uint16_t> raw{32768 - 2000, 32768 - 1990, 32768 - 1989, 32768, 32768 + 2047};
    std::vector<float> values(raw.size());
    applyIntensity(s, raw, values);
    EXPECT_TRUE(std::isnan(values[0]));
    EXPECT_TRUE(std::isnan(values[1]));
    EXPECT_EQ(values[2], static_cast<float>(0.0123457 * -1989 - 3.25));
    EXPECT_EQ(values[3], -3.25F);
    EXPECT_EQ(values[4], static_cast<float>(0.0123457 * 2047 - 3.25));
    s.slope = 1e36;
    applyIntensity(s, raw, values);
    EXPECT_TRUE(std::isnan(values[4]));  // 2e39 is no float
    EXPECT_EQ(values[3], -3.25F);
}

TEST(Intensity, WideCellsAreFloat) {
    const SliceIntensity wide = slice(0.5, 1.0, {32, 32, 31, false}, RawRange{7, 7});
    EXPECT_EQ(planOf({wide, wide}).format, VoxelFormat::float32);
    std::vector<float> values(3);
    applyIntensity(wide, std::vector<double>{7.0, 4294967295.0, 0.0}, values);
    EXPECT_TRUE(std::isnan(values[0]));
    EXPECT_EQ(values[1], static_cast<float>(0.5 * 4294967295.0 + 1.0));
    EXPECT_EQ(values[2], 1.0F);

    SliceIntensity real = slice(2.0, 1.0, floatFormat(CellKind::float64));
    real.floatPadding = ValueRange{-2e9, -1e9};
    applyIntensity(real, std::vector<double>{-1e9, 1e-6, std::numeric_limits<double>::infinity()}, values);
    EXPECT_TRUE(std::isnan(values[0]));
    EXPECT_EQ(values[1], static_cast<float>(1.0 + 2e-6));
    EXPECT_TRUE(std::isnan(values[2]));
}

TEST(ModalityLut, ClampsOutsideItsEntries) {
    const auto lut = readModalityLut({3, 10, 16}, std::vector<std::uint16_t>{500, 100, 65535}, false);
    ASSERT_NE(lut, nullptr);
    EXPECT_EQ((*lut)(0), 500);
    EXPECT_EQ((*lut)(10), 500);
    EXPECT_EQ((*lut)(11), 100);
    EXPECT_EQ((*lut)(12), 65535);
    EXPECT_EQ((*lut)(60000), 65535);
    EXPECT_EQ((*lut)(-4'000'000'000), 500);
}

TEST(ModalityLut, FirstValueHasThePixelsSign) {
    const std::vector<std::uint16_t> data{1, 2};
    EXPECT_EQ(readModalityLut({2, 0xFFFF, 16}, data, true)->firstMapped, -1);
    EXPECT_EQ(readModalityLut({2, 0xFFFF, 16}, data, false)->firstMapped, 65535);
}

TEST(ModalityLut, NoEntriesMeans65536) {
    std::vector<std::uint16_t> data(65536, 3);
    data.back() = 4;
    const auto lut = readModalityLut({0, 0, 16}, data, false);
    ASSERT_NE(lut, nullptr);
    EXPECT_EQ((*lut)(65535), 4);
    data.pop_back();
    EXPECT_EQ(readModalityLut({0, 0, 16}, data, false), nullptr);
}

TEST(ModalityLut, EntriesOfEightBitsMayBePackedInWords) {
    const auto packed = readModalityLut({3, 0, 8}, std::vector<std::uint16_t>{0x0201, 0x0003}, false);
    ASSERT_NE(packed, nullptr);
    EXPECT_EQ(packed->entries, (std::vector<std::uint16_t>{1, 2, 3}));
    const auto wide = readModalityLut({3, 0, 8}, std::vector<std::uint16_t>{1, 2, 255}, false);
    ASSERT_NE(wide, nullptr);
    EXPECT_EQ(wide->entries, (std::vector<std::uint16_t>{1, 2, 255}));
    EXPECT_EQ(readModalityLut({3, 0, 8}, std::vector<std::uint16_t>{1}, false), nullptr);
    EXPECT_EQ(readModalityLut({2, 0, 0}, std::vector<std::uint16_t>{1, 2}, false), nullptr);
}

// With and without a table, padding apart, and a table of its own in each slice.
TEST(ModalityLut, VolumeIsExact) {
    SliceIntensity first = slice(1.0, 0.0, kSignedTwelveBits, RawRange{-2048, -2048});
    first.modalityLut = readModalityLut({4, 0xFFFE, 16}, std::vector<std::uint16_t>{9, 20, 31, 60000}, true);
    SliceIntensity second = slice(2.0, -1.0, kTwelveBits);
    SliceIntensity third = first;
    third.modalityLut = readModalityLut({1, 0, 16}, std::vector<std::uint16_t>{777}, true);
    const IntensityPlan plan = planOf({first, second, third});
    ASSERT_EQ(plan.format, VoxelFormat::stored16);
    EXPECT_EQ(valueOf(plan, 0, 32768 - 2047), 9.0);
    EXPECT_EQ(valueOf(plan, 0, 32768 - 1), 20.0);
    EXPECT_EQ(valueOf(plan, 0, 32768 + 1), 60000.0);
    EXPECT_EQ(valueOf(plan, 0, 32768 + 2047), 60000.0);
    EXPECT_EQ(valueOf(plan, 1, 0), -1.0);
    EXPECT_EQ(valueOf(plan, 1, 4095), 8189.0);
    EXPECT_EQ(valueOf(plan, 2, 32768 + 5), 777.0);
    std::array<std::uint16_t, 1> padding{32768 - 2048};
    applyMap(plan.slices[0], padding);
    ASSERT_TRUE(plan.padding);
    EXPECT_TRUE(plan.padding->contains(padding[0]));

    std::vector<float> values(2);
    applyIntensity(first, std::vector<std::uint16_t>{32768 - 2048, 32768}, values);
    EXPECT_TRUE(std::isnan(values[0]));
    EXPECT_EQ(values[1], 31.0F);
}

}  // namespace
}  // namespace macula::dicom
