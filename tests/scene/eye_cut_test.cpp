// The plane before the eye, and the clip that it joins.
#include "scene/clip/eye_cut.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/phantom.h"
#include "scene/choice/clip_choice.h"
#include "scene/clip/edited_clip.h"
#include "scene/drawing/drawing_of.h"
#include "scene/drawing/shown_clip.h"

namespace macula::scene {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

const Volume& volume() {
    static const Volume made = phantom::make({.size = {12, 10, 8}, .spacingMm = {20, 20, 25}});
    return made;
}

Camera oblique() {
    return {.positionMm = {500, -900, 300}, .targetMm = {0, 0, 0}, .up = {0, 0, 1}, .verticalFovDeg = 30};
}

TEST(EyeCut, RemovesWhatLiesBeforeThePlane) {
    const auto cut = eyeCut(oblique(), 15.0, true, volume());
    ASSERT_TRUE(cut.ok());
    const Clip clip = clipFor(std::nullopt, {.eye = *cut, .scissors = {}}, volume());
    ASSERT_EQ(clip.planes.size(), 1u);
    const glm::dvec3 forward = basis(oblique())->forward;
    const glm::dvec3 on = volume().worldBox().centre() + 15.0 * forward;
    EXPECT_FALSE(shows(clip, on - 0.01 * forward)) << "nearer to the eye";
    EXPECT_TRUE(shows(clip, on + 0.01 * forward));
    EXPECT_NEAR(glm::length(cut->plane.normal - forward), 0.0, 1e-12);
}

TEST(EyeCut, NeverLeavesNothingAndGoesNoFartherThanTheVolume) {
    for (const double mm : {-1e9, -50.0, 0.0, 50.0, 1e9}) {
        const auto cut = eyeCut(oblique(), mm, false, volume());
        ASSERT_TRUE(cut.ok());
        const ValueRange range = eyeCutRangeMm(cut->plane.normal, volume());
        const double planeMm =
            cut->plane.offsetMm - glm::dot(cut->plane.normal, volume().worldBox().centre());
        EXPECT_GE(planeMm, range.low - 1e-9);
        EXPECT_LE(planeMm, range.high + 1e-9);
        EXPECT_EQ(cut->fromMiddleMm, mm) << "as it was asked for";
        Clip clip = clipFor(std::nullopt, {.eye = *cut, .scissors = {}}, volume());
        EXPECT_TRUE(validate(clip).ok());
    }
    const auto nearest = *eyeCut(oblique(), -1e9, false, volume());
    const Clip nothing = clipFor(std::nullopt, {.eye = nearest, .scissors = {}}, volume());
    for (const glm::dvec3& corner : cornersOf(volume().worldBox()))
        EXPECT_GE(glm::dot(nothing.planes[0].normal, corner) - nothing.planes[0].offsetMm, -1e-9);
}

TEST(EyeCut, GoesThroughAPointAndKeepsItsDirection) {
    const EyeCut cut = *eyeCut(oblique(), 0.0, true, volume());
    const glm::dvec3 to = volume().worldBox().centre() + glm::dvec3(10, 20, -30);
    const EyeCut moved = through(cut, to, volume());
    EXPECT_EQ(moved.plane.normal, cut.plane.normal);
    EXPECT_NEAR(glm::dot(moved.plane.normal, to), moved.plane.offsetMm, 1e-9);
    EXPECT_EQ(at(cut, kNan, volume()), cut);
    EXPECT_EQ(through(cut, glm::dvec3(kNan), volume()), cut);
}

TEST(EyeCut, SaysWhatIsWrong) {
    EXPECT_EQ(eyeCut({.positionMm = {1, 1, 1}, .targetMm = {1, 1, 1}}, 0.0, true, volume()).error().code,
              ErrorCode::usage);
    EXPECT_EQ(eyeCut(oblique(), kNan, true, volume()).error().code, ErrorCode::usage);
}

TEST(EyeCut, IsLeftOutWhereTheClipHasSixPlanes) {
    ClipPreset full{.name = "own", .title = "Own clip", .clip = {}, .planesAt = {}};
    for (int i = 0; i < 6; ++i) {
        full.clip.planes.push_back({.normal = glm::normalize(glm::dvec3(1, 1, i)), .offsetMm = 0.0});
        full.planesAt.push_back(glm::dvec3(0.1));
    }
    const Cuts cuts{.eye = *eyeCut(oblique(), 0.0, true, volume()), .scissors = {}};
    EXPECT_FALSE(hasRoomForEyeCut(full));
    EXPECT_EQ(clipFor(full, cuts, volume()).planes.size(), 6u);
    EXPECT_TRUE(validate(clipFor(full, cuts, volume())).ok());
    full.clip.planes.pop_back();
    full.planesAt.pop_back();
    EXPECT_EQ(clipFor(full, cuts, volume()).planes.size(), 6u);
}

// What a window draws and what is drawn of its view without one are the same.
TEST(EyeCut, IsTheSameInAWindowAndWithoutOne) {
    StudyState state;
    state.clip = *chooseClip("left-half");
    state.cuts.eye = *eyeCut(oblique(), 5.0, true, volume());
    Progress progress;
    const auto without = shownClip(state, volume(), progress);
    ASSERT_TRUE(without.ok());
    const auto within = clipOf(state, volume(), std::nullopt);
    ASSERT_TRUE(within);
    EXPECT_EQ(*within, without->clip);
    EXPECT_EQ(within->planes.back(), state.cuts.eye->plane);
}

}  // namespace
}  // namespace macula::scene
