// Differences of two volumes, their window, and their colours.
#include "slices/difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>

namespace macula::slices {
namespace {

constexpr glm::ivec3 kSize{5, 4, 3};
constexpr std::uint16_t kPad = 7;

VolumeOptions optionsOf(double slope, double intercept) {
    VolumeOptions options{.size = kSize,
                          .unitsFromStored = {.slope = slope, .intercept = intercept},
                          .unit = Unit::hounsfield,
                          .modality = "CT"};
    options.padding = StoredRange{kPad, kPad};
    return options;
}

Volume volumeOf(VolumeOptions options, std::uint16_t low) {
    std::vector<std::uint16_t> voxels;
    for (int n = 0; n < kSize.x * kSize.y * kSize.z; ++n) voxels.push_back(std::uint16_t(low + n));
    return Volume::create(std::move(options), std::move(voxels)).value();
}

TEST(Difference, IsOfValuesAndNotOfStoredNumbers) {
    const Volume a = volumeOf(optionsOf(2.0, -1000.0), 100);
    const Volume b = volumeOf(optionsOf(0.5, 10.0), 300);
    const auto difference = differenceOf(a, b);
    ASSERT_TRUE(difference.ok());
    for (int k = 0; k < kSize.z; ++k)
        for (int j = 0; j < kSize.y; ++j)
            for (int i = 0; i < kSize.x; ++i) {
                const double n = i + kSize.x * (j + kSize.y * k);
                EXPECT_NEAR(difference->value(i, j, k), (2.0 * (100 + n) - 1000.0) - (0.5 * (300 + n) + 10.0),
                            1e-3);
            }
    EXPECT_EQ(difference->unitName(), "HU difference");
    EXPECT_EQ(difference->worldFromVoxel(), a.worldFromVoxel());
}

TEST(Difference, HasNoValueWhereEitherHasNone) {
    const Volume padded = volumeOf(optionsOf(1.0, 0.0), 5);  // its third voxel is padding
    const Volume whole = volumeOf(optionsOf(1.0, 0.0), 100);
    for (const auto& difference : {differenceOf(padded, whole), differenceOf(whole, padded)}) {
        ASSERT_TRUE(difference.ok());
        EXPECT_TRUE(difference->isPadding(2, 0, 0));
        EXPECT_FALSE(difference->isPadding(3, 0, 0));
    }
    EXPECT_EQ(differenceOf(whole, whole)->valueRange(), (ValueRange{0.0, 0.0}));
}

TEST(Difference, IsRefusedForAnotherGridOrUnit) {
    const Volume a = volumeOf(optionsOf(1.0, 0.0), 100);
    VolumeOptions moved = optionsOf(1.0, 0.0);
    moved.worldFromVoxel[3].x = 0.01;
    VolumeOptions raw = optionsOf(1.0, 0.0);
    raw.unit = Unit::raw;
    VolumeOptions turned = optionsOf(1.0, 0.0);
    turned.size = {4, 5, 3};
    for (VolumeOptions* options : {&moved, &raw, &turned}) {
        const auto difference = differenceOf(a, volumeOf(*options, 100));
        ASSERT_FALSE(difference.ok());
        EXPECT_EQ(difference.error().code, ErrorCode::inputNotUsable);
    }
    raw.unit = Unit::raw;
    EXPECT_EQ(differenceOf(volumeOf(raw, 1), volumeOf(raw, 2))->unitName(), "difference");
    const CancelToken token;
    token.cancel();
    EXPECT_EQ(differenceOf(a, a, token).error().code, ErrorCode::cancelled);
}

TEST(Difference, TheWindowIsSymmetricAndLeavesOutliersOut) {
    std::vector<float> values(1000, 0.0F);
    for (std::size_t n = 0; n < 500; ++n) values[n] = n % 2 == 0 ? 20.0F : -20.0F;
    values[1] = 5000.0F;
    values[3] = std::numeric_limits<float>::quiet_NaN();
    const auto volume = Volume::createFloat({.size = {10, 10, 10}, .unit = Unit::other}, std::move(values));
    const DisplayWindow window = symmetricWindow(*volume);
    EXPECT_EQ(window.center, 0.0);
    EXPECT_EQ(window.width, 40.0);
    const auto flat = Volume::createFloat({.size = {1, 1, 2}, .unit = Unit::other}, {0.0F, 0.0F});
    EXPECT_GT(symmetricWindow(*flat).width, 0.0);
}

TEST(Difference, ColoursAreBlueBelowAndOrangeAboveAndBlackIsNoValue) {
    const DisplayWindow window{.center = 0.0, .width = 200.0, .explanation = {}, .function = {}};
    const float none = std::numeric_limits<float>::quiet_NaN();
    const float most = std::numeric_limits<float>::infinity();
    const std::vector<std::uint32_t> pixels =
        toDiverging(std::vector<float>{none, 0.0F, -60.0F, 60.0F, -100.0F, 100.0F, -most, most}, window);
    const auto part = [&](std::size_t n, int shift) { return int(pixels[n] >> unsigned(shift) & 0xFFU); };
    EXPECT_EQ(pixels[0], 0xFF000000U);
    EXPECT_EQ(part(1, 16), part(1, 0));
    EXPECT_GT(part(1, 0), 0) << "no change is no lack of a value";
    EXPECT_GT(part(2, 0), part(2, 16) + 100);
    EXPECT_GT(part(3, 16), part(3, 0) + 100);
    EXPECT_EQ(pixels[4], pixels[6]);
    EXPECT_EQ(pixels[5], pixels[7]);
    // The larger the difference, the brighter, to both sides.
    std::vector<float> rising;
    for (int n = 0; n <= 100; ++n) rising.push_back(float(n));
    for (const float side : {1.0F, -1.0F}) {
        double before = -1.0;
        for (const float value : rising) {
            const std::uint32_t pixel = toDiverging(std::vector<float>{side * value}, window).front();
            const double light = 0.2126 * double(pixel >> 16U & 0xFFU) +
                                 0.7152 * double(pixel >> 8U & 0xFFU) + 0.0722 * double(pixel & 0xFFU);
            EXPECT_GE(light, before);
            before = light;
        }
    }
}

}  // namespace
}  // namespace macula::slices
