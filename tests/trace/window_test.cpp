#include "pipeline/volume/window.h"

#include <gtest/gtest.h>

#include <limits>

namespace macula {
namespace {

// Water with a plate of bone behind all of it: every ray meets 1000 HU.
Volume plate(std::vector<DisplayWindow> windows, int boneRows) {
    std::vector<std::uint16_t> voxels(std::size_t{24} * 24 * 24, 1024);
    for (std::size_t n = 0; n < voxels.size(); ++n) {
        const auto j = int(n / 24 % 24);
        if (j < boneRows) voxels[n] = 2024;
    }
    auto made = Volume::create({.size = {24, 24, 24},
                                .worldFromVoxel = glm::dmat4(1.0),
                                .unitsFromStored = {.slope = 1.0, .intercept = -1024.0},
                                .unit = Unit::hounsfield,
                                .modality = "CT",
                                .provenance = {},
                                .windows = std::move(windows)},
                               std::move(voxels));
    return std::move(made).value();
}

DisplayWindow window(double center, double width) {
    return {.center = center, .width = width, .explanation = {}, .function = {}};
}

TEST(MaximumWindow, IsThatOfTheSeriesWhereItFits) {
    const Volume bone = plate({window(500, 2000)}, 4);
    EXPECT_EQ(maximumWindow(bone), window(500, 2000));
    EXPECT_EQ(seriesWindow(bone), window(500, 2000));
}

// A window for soft tissue is made for slices: of the largest values along rays nearly all lie above it.
TEST(MaximumWindow, IsFittedWhereThatOfTheSeriesIsWhite) {
    const Volume bone = plate({window(40, 400)}, 4);
    const DisplayWindow fitted = maximumWindow(bone);
    EXPECT_EQ(fitted.center + fitted.width / 2.0, 1000.0);
    EXPECT_LE(fitted.center - fitted.width / 2.0, 1000.0);
    EXPECT_EQ(maximumWindow(plate({}, 4)), fitted);
}

Volume activity(Unit unit, const char* modality, std::vector<float> voxels,
                std::vector<DisplayWindow> windows = {}) {
    const auto count = int(voxels.size());
    VolumeOptions options{.size = {count, 1, 1}, .unit = unit, .modality = modality};
    options.windows = std::move(windows);
    auto made = Volume::createFloat(std::move(options), std::move(voxels));
    return *std::move(made);
}

double highOf(const DisplayWindow& of) {
    return of.center + 0.5 * of.width;
}

TEST(ActivityWindow, OfSuvGoesToTenOrToTheHighest) {
    const DisplayWindow usual =
        seriesWindow(activity(Unit::suvBodyWeight, "PT", {0.0F, 2.5F, 80.0F}, {window(40, 80)}));
    EXPECT_DOUBLE_EQ(usual.center, 5.0) << "whatever the scanner says";
    EXPECT_DOUBLE_EQ(usual.width, 10.0);
    EXPECT_DOUBLE_EQ(highOf(seriesWindow(activity(Unit::suvBodyWeight, "PT", {0.0F, 2.5F, 4.0F}))), 4.0);
}

// A bladder of one voxel in two thousand leaves the rest grey and not black.
TEST(ActivityWindow, OfOtherPetLeavesTheHottestOut) {
    std::vector<float> voxels(10'000, 500.0F);
    for (std::size_t n = 0; n < 100; ++n) voxels[n * 97] = 8000.0F;
    for (std::size_t n = 0; n < 5; ++n) voxels[n * 1997 + 1] = 273'860.0F;
    for (const Unit unit : {Unit::becquerelsPerMillilitre, Unit::raw}) {
        const DisplayWindow usual = seriesWindow(activity(unit, "PT", voxels, {window(136'930, 273'860)}));
        EXPECT_DOUBLE_EQ(usual.center - 0.5 * usual.width, 0.0);
        EXPECT_NEAR(highOf(usual), 8000.0, 1.0);
    }
    EXPECT_EQ(seriesWindow(activity(Unit::raw, "MR", voxels, {window(136'930, 273'860)})),
              window(136'930, 273'860));
}

TEST(ActivityWindow, OfNothingIsThatOfTheSeries) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float value : {0.0F, -3.0F, nan}) {
        const Volume empty =
            activity(Unit::becquerelsPerMillilitre, "PT", std::vector<float>(27, value), {window(3, 4)});
        EXPECT_FALSE(activityWindow(empty));
        EXPECT_EQ(seriesWindow(empty), window(3, 4));
    }
}

TEST(MaximumWindow, OfPaddingAloneIsSomeWindow) {
    auto made = Volume::create({.size = {4, 4, 4},
                                .worldFromVoxel = glm::dmat4(1.0),
                                .unitsFromStored = {},
                                .unit = Unit::raw,
                                .modality = "OT",
                                .padding = StoredRange{0, 0},
                                .provenance = {}},
                               std::vector<std::uint16_t>(64, 0));
    EXPECT_GT(maximumWindow(*made).width, 0.0);
}

}  // namespace
}  // namespace macula
