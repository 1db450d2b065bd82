#include <gtest/gtest.h>

#include "base/phantom.h"

namespace macula {
namespace {

// Of whole blocks of voxels much is not asked; of a single point all is.
TEST(Phantom, VoxelsAreTheClosedFormAtTheirCentres) {
    const phantom::Options coarse{
        .size = {63, 57, 41}, .spacingMm = {4.8, 4.8, 7.5}, .tiltDeg = {20, 10, 30}};
    for (const phantom::Options& options : {phantom::Options{}, coarse}) {
        const Volume volume = phantom::make(options);
        const glm::ivec3 size = options.size;
        int wrong = 0;
        for (int at = 0; at < size.x * size.y * size.z; at += 29) {
            const glm::ivec3 voxel{at % size.x, at / size.x % size.y, at / size.x / size.y};
            const glm::dvec3 world = transformPoint(volume.worldFromVoxel(), glm::dvec3(voxel));
            wrong += volume.value(voxel.x, voxel.y, voxel.z) == phantom::valueHu(world) ? 0 : 1;
        }
        EXPECT_EQ(wrong, 0);
    }
}

TEST(Phantom, IsAsymmetricTheRightWayRound) {
    EXPECT_EQ(phantom::valueHu(phantom::markerCentreMm()), 1000);  // on the patient's left: +x
    EXPECT_GT(phantom::markerCentreMm().x, 0.0);
    EXPECT_EQ(phantom::valueHu({-128, -30, 60}), -90);  // fat, where a mirrored marker would be
    EXPECT_EQ(phantom::valueHu({-52, -6, -92}), 110);   // liver, right
    EXPECT_EQ(phantom::valueHu({38, -24, -24}), 330);   // left ventricle, left
    EXPECT_EQ(phantom::valueHu({0, 58, 0}), 320);       // spine, posterior
    EXPECT_EQ(phantom::valueHu({0, -400, 0}), -1000);
}

TEST(Phantom, GridIsObliqueAndAnisotropic) {
    const Volume volume = phantom::make();
    const glm::dvec3 spacing = volume.spacingMm();
    EXPECT_NEAR(spacing.x, 1.2, 1e-12);
    EXPECT_NEAR(spacing.z, 1.875, 1e-12);
    EXPECT_EQ(orientationLetters(glm::dvec3(volume.worldFromVoxel()[0])).size(),
              2u);  // about z only, then none left
    EXPECT_GT(std::abs(volume.worldFromVoxel()[2].y), 0.01);
}

}  // namespace
}  // namespace macula
