// Slices on a localizer, in closed form.
#include "study/planar/localizer_lines.h"

#include <gtest/gtest.h>

#include <cmath>

namespace macula::study {
namespace {

Volume volumeAt(const glm::dmat4& worldFromVoxel, const glm::ivec3& size) {
    std::vector<std::uint16_t> voxels(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z), 7);
    auto volume =
        Volume::create({.size = size, .worldFromVoxel = worldFromVoxel, .modality = "CT"}, std::move(voxels));
    EXPECT_TRUE(volume);
    return *std::move(volume);
}

// Seen from in front: columns to the patient's left, rows to the feet, 0.5 mm.
dicom::ImagePlane coronal() {
    return {.positionMm = {-100, 20, 300},
            .rowDirection = {1, 0, 0},
            .columnDirection = {0, 0, -1},
            .columnSpacingMm = 0.5,
            .rowSpacingMm = 0.5};
}

// Axial slices of 10 x 8 pixels of 2 mm, 5 mm apart.
glm::dmat4 axial() {
    glm::dmat4 worldFromVoxel(1.0);
    worldFromVoxel[0] = {2, 0, 0, 0};
    worldFromVoxel[1] = {0, 2, 0, 0};
    worldFromVoxel[2] = {0, 0, 5, 0};
    worldFromVoxel[3] = {-40, -30, 100, 1};
    return worldFromVoxel;
}

TEST(LocalizerLines, OfAxialSlicesAreRowsOfACoronalScout) {
    const Volume volume = volumeAt(axial(), {10, 8, 6});
    const auto slices = slicesOn(coronal(), volume);
    ASSERT_EQ(slices.size(), 6u);
    for (int k = 0; k < 6; ++k) {
        const double row = (300.0 - (100.0 + 5.0 * k)) / 0.5 + 0.5;
        for (const glm::dvec2& corner : slices[std::size_t(k)].corners) EXPECT_NEAR(corner.y, row, 1e-9);
        // The outer edges of the first and the last column: 1 mm beyond their middles.
        EXPECT_NEAR(slices[std::size_t(k)].corners[0].x, (-41.0 + 100.0) / 0.5 + 0.5, 1e-9);
        EXPECT_NEAR(slices[std::size_t(k)].corners[1].x, (-21.0 + 100.0) / 0.5 + 0.5, 1e-9);
    }
    EXPECT_EQ(sliceNearest({0, 0, 111}, volume), 2);
    EXPECT_EQ(sliceNearest({0, 0, -1e9}, volume), 0);
    EXPECT_EQ(sliceNearest({0, 0, std::nan("")}, volume), 0);
}

TEST(LocalizerLines, OfTiltedSlicesOpenAsFarAsTheyAreTilted) {
    glm::dmat4 tilted = axial();
    const double angle = glm::radians(20.0);
    tilted[1] = {0, 2 * std::cos(angle), 2 * std::sin(angle), 0};
    const auto slices = slicesOn(coronal(), volumeAt(tilted, {10, 8, 2}));
    ASSERT_EQ(slices.size(), 2u);
    EXPECT_NEAR(slices[0].corners[1].y - slices[0].corners[2].y, 8 * 2 * std::sin(angle) / 0.5, 1e-9);
}

TEST(LocalizerLines, OfSlicesThatLieAlongItAreNone) {
    glm::dmat4 along = axial();
    along[1] = {0, 0, 2, 0};
    along[2] = {0, 5, 0, 0};
    EXPECT_TRUE(slicesOn(coronal(), volumeAt(along, {10, 8, 2})).empty());
    dicom::ImagePlane none = coronal();
    none.rowDirection = {0, 0, 0};
    EXPECT_TRUE(slicesOn(none, volumeAt(axial(), {10, 8, 2})).empty());
}

}  // namespace
}  // namespace macula::study
