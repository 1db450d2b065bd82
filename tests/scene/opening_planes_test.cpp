#include "scene/slices/opening_planes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace macula::scene {
namespace {

using slices::Orientation;

// Images of 20 x 20 mm, so many of them so far apart, tilted about the patient's left-right axis.
Volume stack(int images, double apartMm, double tiltDeg, Orientation orientation = Orientation::axial) {
    const double tilt = tiltDeg * std::numbers::pi / 180.0;
    glm::dvec3 i{1, 0, 0};
    glm::dvec3 j{0, std::cos(tilt), std::sin(tilt)};
    if (orientation == Orientation::sagittal) {
        i = {0, 1, 0};
        j = {0, 0, -1};
    }
    if (orientation == Orientation::coronal) j = {0, 0, -1};
    auto volume = Volume::create(
        {.size = {20, 20, images}, .worldFromVoxel = affine(i, j, glm::cross(i, j) * apartMm, {0, 0, 0})},
        std::vector<std::uint16_t>(std::size_t(400) * std::size_t(images)));
    return *std::move(volume);
}

TEST(OpeningPlanes, ATiltedHeadOpensInItsImages) {
    EXPECT_FALSE(openingPlanes(stack(20, 1.0, 0.0)).asAcquired);
    EXPECT_FALSE(openingPlanes(stack(20, 1.0, 4.0)).asAcquired);
    EXPECT_TRUE(openingPlanes(stack(20, 1.0, 6.0)).asAcquired);
    EXPECT_TRUE(openingPlanes(stack(20, 1.0, -20.0)).asAcquired);
    EXPECT_FALSE(openingPlanes(stack(20, 1.0, 0.0, Orientation::sagittal)).asAcquired);
}

TEST(OpeningPlanes, OfAThinStackItsImagesAreLarge) {
    for (const auto orientation : {Orientation::axial, Orientation::coronal, Orientation::sagittal}) {
        EXPECT_EQ(openingPlanes(stack(5, 1.0, 0.0, orientation)).largest, orientation);
        EXPECT_EQ(openingPlanes(stack(5, 4.0, 0.0, orientation)).largest, std::nullopt);
    }
}

}  // namespace
}  // namespace macula::scene
