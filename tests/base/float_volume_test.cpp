#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <limits>

#include "base/fingerprint.h"
#include "base/volume.h"

namespace macula {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kSmallestDenormal = std::numeric_limits<float>::denorm_min();
constexpr float kLargest = std::numeric_limits<float>::max();

std::shared_ptr<const Volume> floatVolume(std::vector<float> voxels, VolumeOptions options = {}) {
    if (options.size == glm::ivec3(0)) options.size = {static_cast<int>(voxels.size()), 1, 1};
    auto volume = Volume::createFloat(std::move(options), std::move(voxels));
    EXPECT_TRUE(volume.ok());
    return std::make_shared<const Volume>(std::move(*volume));
}

std::shared_ptr<const Volume> storedVolume(std::vector<std::uint16_t> voxels, VolumeOptions options = {}) {
    if (options.size == glm::ivec3(0)) options.size = {static_cast<int>(voxels.size()), 1, 1};
    auto volume = Volume::create(std::move(options), std::move(voxels));
    EXPECT_TRUE(volume.ok());
    return std::make_shared<const Volume>(std::move(*volume));
}

TEST(FloatVolume, KeepsTheValuesAsTheyAre) {
    const auto volume = floatVolume({1e6F, 1e-6F, -0.0F, kSmallestDenormal, -kLargest});
    EXPECT_EQ(volume->format(), VoxelFormat::float32);
    EXPECT_EQ(volume->voxelCount(), 5u);
    EXPECT_EQ(volume->value(0, 0, 0), double{1e6F});
    EXPECT_EQ(volume->value(1, 0, 0), double{1e-6F});
    EXPECT_TRUE(std::signbit(volume->value(2, 0, 0)));
    EXPECT_EQ(volume->value(3, 0, 0), double{kSmallestDenormal});
    EXPECT_EQ(volume->floatVoxels()[4], -kLargest);
    EXPECT_EQ(volume->valueRange(), (ValueRange{-kLargest, 1e6F}));
}

TEST(FloatVolume, NotANumberAndInfinityArePadding) {
    const auto volume = floatVolume({kNan, 3.0F, kInfinity, -kInfinity, -2.0F, -kNan});
    EXPECT_EQ(volume->valueRange(), (ValueRange{-2.0, 3.0}));
    for (const int i : {0, 2, 3, 5}) {
        EXPECT_TRUE(volume->isPadding(i, 0, 0)) << i;
        EXPECT_TRUE(std::isnan(volume->value(i, 0, 0))) << i;
    }
    EXPECT_FALSE(volume->isPadding(1, 0, 0));
    EXPECT_FALSE(volume->isPadding(4, 0, 0));
}

TEST(FloatVolume, PaddingValueIsOutOfTheRangeAndStays) {
    const auto volume = floatVolume({-1e6F, 4.0F, kNan, 5.0F}, {.floatPadding = -1e6F});
    EXPECT_EQ(volume->valueRange(), (ValueRange{4.0, 5.0}));
    EXPECT_TRUE(volume->isPadding(0, 0, 0));
    EXPECT_EQ(volume->value(0, 0, 0), -1e6);
    EXPECT_TRUE(volume->isPadding(2, 0, 0));
}

TEST(FloatVolume, AllPaddingHasNoRange) {
    EXPECT_FALSE(floatVolume({kNan})->valueRange());
    EXPECT_FALSE(floatVolume({7.0F, kNan, kInfinity}, {.floatPadding = 7.0F})->valueRange());
    EXPECT_FALSE(storedVolume({4, 5}, {.padding = StoredRange{0, 9}})->valueRange());
}

TEST(FloatVolume, RangeIsThatOfAllChunks) {
    std::vector<float> voxels(3001 * 1000, 1.0F);
    voxels.front() = kNan;
    voxels[1'500'000] = -8.0F;
    voxels.back() = 9.0F;
    EXPECT_EQ(floatVolume(std::move(voxels), {.size = {3001, 1000, 1}})->valueRange(),
              (ValueRange{-8.0, 9.0}));
}

TEST(FloatVolume, RangeOfStoredValuesIsInUnits) {
    const auto volume = storedVolume(
        {10, 20, 0}, {.unitsFromStored = {.slope = 0.5, .intercept = -3.0}, .padding = StoredRange{0, 0}});
    EXPECT_EQ(volume->valueRange(), (ValueRange{2.0, 7.0}));
    EXPECT_TRUE(volume->isPadding(2, 0, 0));
    EXPECT_FALSE(volume->isPadding(0, 0, 0));
}

TEST(FloatVolume, RefusesWhatIsNoVolume) {
    EXPECT_FALSE(Volume::createFloat({.size = {2, 1, 1}}, {1.0F}).ok());
    EXPECT_FALSE(Volume::createFloat({.size = {0, 1, 1}}, {}).ok());
}

TEST(FloatVolumeDeathTest, VoxelsOfTheOtherFormatAreAProgrammersError) {
    const auto real = floatVolume({1.0F});
    const auto stored = storedVolume({1});
    EXPECT_DEATH((void)real->voxels(), "stored16");
    EXPECT_DEATH((void)real->storedRange(), "stored16");
    EXPECT_DEATH((void)real->airStored(), "stored16");
    EXPECT_DEATH((void)stored->floatVoxels(), "float32");
    EXPECT_DEATH((void)Volume::createFloat(
                     {.size = {1, 1, 1}, .unitsFromStored = {.slope = 2.0, .intercept = 0.0}}, {1.0F}),
                 "unitsFromStored");
}

TEST(In16Bits, StoredVolumeIsItself) {
    const auto volume = storedVolume({1, 2, 3});
    EXPECT_EQ(in16Bits(volume), volume);
}

// Every value within half a step, the extremes at the ends, padding apart from every value.
TEST(In16Bits, ErrorIsWithinHalfAStepAndStated) {
    const std::vector<std::vector<float>> sets{
        {0.0F, 1e6F, 12345.678F, kNan, 1e-6F},
        {1e-6F, 2e-6F, 1.0000001e-6F},
        {-kLargest, 1.0F, kLargest, kInfinity},
        {0.0F, kSmallestDenormal, 3 * kSmallestDenormal},
        {16777216.0F, 16847218.0F, 16777218.0F},  // whole numbers, and too many
        {-1000.0F, 3071.0F, 0.25F},
    };
    for (const auto& voxels : sets) {
        const auto real = floatVolume(voxels);
        const auto volume = in16Bits(real);
        ASSERT_EQ(volume->format(), VoxelFormat::stored16);
        const ValueRange range = *real->valueRange();
        const double bound =
            0.5 * (range.high - range.low) / 65534.0 * (1 + 1e-9) + 1e-12 * std::abs(range.high);
        for (int i = 0; i < volume->size().x; ++i) {
            ASSERT_EQ(volume->isPadding(i, 0, 0), real->isPadding(i, 0, 0)) << i;
            if (real->isPadding(i, 0, 0)) continue;
            EXPECT_NEAR(volume->value(i, 0, 0), real->value(i, 0, 0), bound) << i;
        }
        EXPECT_EQ(volume->storedRange(), (StoredRange{1, 65535}));
        ASSERT_EQ(volume->provenance().assumptions.size(), 1u);
        EXPECT_NE(volume->provenance().assumptions[0].english().find("error of at most"), std::string::npos);
    }
}

TEST(In16Bits, WholeNumbersAreKeptExactly) {
    for (const auto& voxels : std::vector<std::vector<float>>{
             {-1024.0F, 3071.0F, kNan, 17.0F}, {0.0F, 65534.0F, 1.0F}, {16777216.0F, 16777218.0F, 0.5F}}) {
        const auto volume = in16Bits(floatVolume(voxels, {.floatPadding = 0.5F}));
        for (int i = 0; i < volume->size().x; ++i) {
            const float value = voxels[static_cast<std::size_t>(i)];
            const bool isPadding = std::isnan(value) || value == 0.5F;
            EXPECT_EQ(volume->isPadding(i, 0, 0), isPadding);
            if (!isPadding) {
                EXPECT_EQ(volume->value(i, 0, 0), double{value});
            }
        }
        EXPECT_TRUE(volume->provenance().assumptions.empty());
    }
}

TEST(In16Bits, OneValueIsKeptExactly) {
    for (const float value : {0.0F, 5.0F, -5.0F, 1e-6F, 1e6F, -kLargest, kSmallestDenormal}) {
        const auto volume = in16Bits(floatVolume({value, kNan}));
        EXPECT_EQ(volume->value(0, 0, 0), double{value});
        EXPECT_FALSE(volume->isPadding(0, 0, 0));
        EXPECT_TRUE(volume->isPadding(1, 0, 0));
    }
}

// An error without a unit says nothing; numbers of the scanner have none.
TEST(In16Bits, ErrorIsToldInTheUnitOfTheValues) {
    const std::vector<float> voxels{0.0F, 1e3F, 12.345F};
    const auto noteOf = [&](Unit unit, const std::string& name) {
        VolumeOptions options{.unit = unit, .modality = "PT"};
        options.unitName = name;
        return in16Bits(floatVolume(voxels, options))->provenance().assumptions.at(0).english();
    };
    EXPECT_TRUE(noteOf(Unit::suvBodyWeight, "").ends_with(" SUV bw."));
    EXPECT_TRUE(noteOf(Unit::becquerelsPerMillilitre, "").ends_with(" Bq/mL."));
    EXPECT_TRUE(noteOf(Unit::other, "mSv").ends_with(" mSv."));
    EXPECT_TRUE(std::isdigit(static_cast<unsigned char>(noteOf(Unit::raw, "").rbegin()[1])));
}

TEST(In16Bits, AllPaddingStaysPadding) {
    const auto volume = in16Bits(floatVolume({kNan, 8.0F}, {.floatPadding = 8.0F}));
    EXPECT_TRUE(volume->isPadding(0, 0, 0));
    EXPECT_TRUE(volume->isPadding(1, 0, 0));
}

TEST(In16Bits, KeepsWhatIsKnownOfTheVolume) {
    const auto volume = in16Bits(floatVolume(
        {1.0F, 2.0F}, {.worldFromVoxel = affine({2, 0, 0}, {0, 3, 0}, {0, 1, 4}, {10, 20, 30}),
                       .unit = Unit::other,
                       .modality = "PT",
                       .provenance = {.seriesInstanceUid = "1.2", .interpolatedSlices = {{0, 0}}},
                       .unitName = "mSv",
                       .windows = {{.center = 3.0, .width = 4.0, .explanation = "A", .function = {}}}}));
    EXPECT_EQ(volume->worldFromVoxel()[3][2], 30.0);
    EXPECT_EQ(volume->unit(), Unit::other);
    EXPECT_EQ(volume->unitName(), "mSv");
    EXPECT_EQ(volume->modality(), "PT");
    EXPECT_EQ(volume->provenance().seriesInstanceUid, "1.2");
    EXPECT_EQ(volume->provenance().interpolatedSlices, (std::vector<SliceRange>{{0, 0}}));
    ASSERT_EQ(volume->windows().size(), 1u);
    EXPECT_EQ(volume->windows()[0].center, 3.0);
}

// Five slices of 2 x 2.
std::vector<std::uint16_t> twentyVoxels() {
    std::vector<std::uint16_t> voxels(20);
    for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = static_cast<std::uint16_t>(100 * i);
    return voxels;
}

TEST(Fingerprint, SameVolumeHasTheSame) {
    const VolumeOptions options{.size = {2, 2, 5}};
    const std::string first = fingerprint(*storedVolume(twentyVoxels(), options));
    EXPECT_EQ(first.size(), 64u);
    EXPECT_EQ(first, fingerprint(*storedVolume(twentyVoxels(), options)));
    VolumeOptions named = options;
    named.provenance.seriesInstanceUid = "1.2.3";
    EXPECT_EQ(first, fingerprint(*storedVolume(twentyVoxels(), named)));
}

// What people are told of the unit has changed; models that were stored of it are found.
TEST(Fingerprint, OfSuvIsAsItWas) {
    const VolumeOptions suv{.size = {2, 2, 5}, .unit = Unit::suvBodyWeight};
    VolumeOptions before{.size = {2, 2, 5}, .unit = Unit::other};
    before.unitName = "g/mL";
    EXPECT_EQ(fingerprint(*storedVolume(twentyVoxels(), suv)),
              fingerprint(*storedVolume(twentyVoxels(), before)));
    before.unitName = "mSv";
    EXPECT_NE(fingerprint(*storedVolume(twentyVoxels(), suv)),
              fingerprint(*storedVolume(twentyVoxels(), before)));
}

TEST(Fingerprint, OtherPixelsUnderTheSameUidDiffer) {
    const VolumeOptions options{.size = {2, 2, 5}, .provenance = {.seriesInstanceUid = "1.2.3"}};
    const std::string first = fingerprint(*storedVolume(twentyVoxels(), options));
    for (std::size_t changed = 0; changed < 20; ++changed) {
        auto voxels = twentyVoxels();
        ++voxels[changed];
        EXPECT_NE(first, fingerprint(*storedVolume(voxels, options))) << changed;
    }
}

TEST(Fingerprint, OrderOfSlicesCounts) {
    const VolumeOptions options{.size = {2, 2, 5}};
    auto voxels = twentyVoxels();
    const std::string first = fingerprint(*storedVolume(voxels, options));
    std::swap_ranges(voxels.begin() + 4, voxels.begin() + 8, voxels.begin() + 12);
    EXPECT_NE(first, fingerprint(*storedVolume(voxels, options)));
}

TEST(Fingerprint, GeometryUnitsAndFormatCount) {
    const VolumeOptions options{.size = {2, 2, 5}};
    const std::string first = fingerprint(*storedVolume(twentyVoxels(), options));
    VolumeOptions other = options;
    other.size = {2, 5, 2};
    EXPECT_NE(first, fingerprint(*storedVolume(twentyVoxels(), other)));
    other = options;
    other.worldFromVoxel[3][0] = std::nextafter(0.0, 1.0);
    EXPECT_NE(first, fingerprint(*storedVolume(twentyVoxels(), other)));
    other = options;
    other.unitsFromStored.intercept = -1024.0;
    EXPECT_NE(first, fingerprint(*storedVolume(twentyVoxels(), other)));
    other = options;
    other.unit = Unit::hounsfield;
    EXPECT_NE(first, fingerprint(*storedVolume(twentyVoxels(), other)));
    const std::vector<std::uint16_t> stored = twentyVoxels();
    EXPECT_NE(first, fingerprint(*floatVolume({stored.begin(), stored.end()}, options)));
}

}  // namespace
}  // namespace macula
