// A shape in mm becomes a clip that is kept with the study, and comes back as it was.
#include "scene/clip/clip_of_shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/phantom.h"

namespace macula::scene {
namespace {

Volume someVolume() {
    return phantom::make({.size = {12, 10, 8}, .spacingMm = {20, 20, 25}});
}

Clip throughTheMiddle(const Volume& volume) {
    const glm::dvec3 middle = volume.worldBox().centre();
    Clip clip;
    for (const glm::dvec3 along : {glm::dvec3(1, 2, 3), glm::dvec3(-1, 0.2, 0.1)}) {
        HalfSpace plane;
        plane.normal = glm::normalize(along);
        plane.offsetMm = glm::dot(plane.normal, middle) - 7.0;
        clip.planes.push_back(plane);
    }
    clip.box = OrientedBox{.centreMm = middle + glm::dvec3(5, 6, 7), .halfSizeMm = {10, 20, 30}};
    clip.ofBox = Keep::outside;
    clip.ball = Ball{.centreMm = middle - glm::dvec3(20, 0, 10), .radiusMm = 25.0};
    clip.ofBall = Keep::outside;
    return clip;
}

TEST(ClipOfShape, ComesBackAsItWas) {
    const Volume volume = someVolume();
    const Clip clip = throughTheMiddle(volume);
    const auto kept = clipOfShape(clip, {}, volume);
    ASSERT_TRUE(kept && kept->has_value());
    const Clip again = clipFor(**kept, volume);
    ASSERT_EQ(again.planes.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_NEAR(glm::distance(again.planes[i].normal, clip.planes[i].normal), 0.0, 1e-12);
        EXPECT_NEAR(again.planes[i].offsetMm, clip.planes[i].offsetMm, 1e-6);
    }
    EXPECT_NEAR(glm::distance(again.box->centreMm, clip.box->centreMm), 0.0, 1e-9);
    EXPECT_NEAR(glm::distance(again.box->halfSizeMm, clip.box->halfSizeMm), 0.0, 1e-9);
    EXPECT_NEAR(glm::distance(again.ball->centreMm, clip.ball->centreMm), 0.0, 1e-9);
    EXPECT_NEAR(again.ball->radiusMm, clip.ball->radiusMm, 1e-9);
    EXPECT_EQ(again.ofBox, Keep::outside);
    EXPECT_EQ(again.ofBall, Keep::outside);
}

TEST(ClipOfShape, FacesStayThoseOfTheClipBefore) {
    const Volume volume = someVolume();
    ClipPreset before;
    before.greyFacesOfSeries = true;
    before.clip.facesBelowWindowAreBlack = true;
    Clip clip = throughTheMiddle(volume);
    clip.greyFaces = clipFor(before, volume).greyFaces;
    clip.facesBelowWindowAreBlack = true;
    const auto kept = clipOfShape(clip, before, volume);
    ASSERT_TRUE(kept && kept->has_value());
    EXPECT_TRUE((*kept)->greyFacesOfSeries);
    EXPECT_FALSE((*kept)->clip.greyFaces);
    EXPECT_TRUE((*kept)->clip.facesBelowWindowAreBlack);
}

TEST(ClipOfShape, NothingIsNoClipAndWhatCannotBeKeptIsRefused) {
    const Volume volume = someVolume();
    const auto nothing = clipOfShape({}, {}, volume);
    ASSERT_TRUE(nothing.ok());
    EXPECT_FALSE(nothing->has_value());
    Clip turned = throughTheMiddle(volume);
    const double turn = 0.3;
    turned.box->axes =
        glm::dmat3(std::cos(turn), std::sin(turn), 0, -std::sin(turn), std::cos(turn), 0, 0, 0, 1);
    EXPECT_EQ(clipOfShape(turned, {}, volume).error().code, ErrorCode::usage);
    Clip none = throughTheMiddle(volume);
    none.ball->radiusMm = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(clipOfShape(none, {}, volume).ok());
}

}  // namespace
}  // namespace macula::scene
