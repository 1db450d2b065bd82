#include <gtest/gtest.h>

#include "base/phantom.h"

namespace macula {
namespace {

TEST(Phantom, VoxelsAreTheClosedFormAtTheirCentres) {
    const Volume volume = phantom::make();
    for (const glm::ivec3 voxel :
         {glm::ivec3{0, 0, 0}, {80, 70, 60}, {40, 72, 60}, {101, 33, 17}, {255, 223, 159}}) {
        const glm::dvec3 world = transformPoint(volume.worldFromVoxel(), glm::dvec3(voxel));
        EXPECT_EQ(volume.value(voxel.x, voxel.y, voxel.z), phantom::valueHu(world));
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
