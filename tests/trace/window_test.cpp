#include "pipeline/volume/window.h"

#include <gtest/gtest.h>

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
