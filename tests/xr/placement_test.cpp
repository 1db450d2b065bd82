// Where the anatomy stands, and how hands move it.
#include "xr/placement.h"

#include <gtest/gtest.h>

namespace macula::xr {
namespace {

const Box kSeen{{-150, -100, -300}, {150, 140, 300}};

Pose turned(const glm::dvec3& positionM, const glm::dvec3& axis, double degrees) {
    return {positionM, glm::angleAxis(glm::radians(degrees), glm::normalize(axis))};
}

void expectNear(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-9) {
    EXPECT_NEAR(glm::distance(a, b), 0.0, tolerance)
        << a.x << " " << a.y << " " << a.z << " instead of " << b.x << " " << b.y << " " << b.z;
}

TEST(Placement, StandsBeforeWhoLooksAtRealWorldScale) {
    for (const double degrees : {0.0, 37.0, -120.0}) {
        const Pose head = turned({0.2, 1.7, -0.3}, {0, 1, 0}, degrees);
        const glm::dmat4 placed = stageFromWorldBefore(head, kSeen);
        EXPECT_NEAR(scaleOf(placed), 1.0, 1e-9);
        EXPECT_GT(glm::determinant(glm::dmat3(placed)), 0.0) << "mirrored";
        const glm::dvec3 ahead = head.orientation * glm::dvec3(0, 0, -1);
        const glm::dvec3 right = head.orientation * glm::dvec3(1, 0, 0);
        const glm::dvec3 towards = transformPoint(placed, kSeen.centre()) - head.positionM;
        EXPECT_NEAR(glm::dot(towards, right), 0.0, 1e-9);
        EXPECT_NEAR(towards.y, 0.0, 1e-9);
        EXPECT_NEAR(glm::dot(towards, ahead), 0.35 + 0.0005 * kSeen.diagonal(), 1e-9);
        expectNear(transformVector(placed, {100, 0, 0}), 0.1 * right);            // left is at the right
        expectNear(transformVector(placed, {0, -100, 0}), -0.1 * ahead);          // anterior faces who looks
        expectNear(transformVector(placed, {0, 0, 100}), glm::dvec3(0, 0.1, 0));  // and the head is up
    }
}

TEST(Placement, ALookToTheCeilingDoesNotTiltIt) {
    for (const double degrees : {90.0, -90.0}) {  // up, and to the floor
        const glm::dmat4 placed = stageFromWorldBefore(turned({0, 1.7, 0}, {1, 0, 0}, degrees), kSeen);
        EXPECT_NEAR(scaleOf(placed), 1.0, 1e-9);
        expectNear(transformVector(placed, {0, 0, 1000}), {0, 1, 0});
        EXPECT_LT(transformPoint(placed, kSeen.centre()).z, -0.35) << "it is behind who looks " << degrees;
        expectNear(transformVector(placed, {0, -1000, 0}), {0, 0, 1});
    }
}

TEST(Placement, FollowsTheHandThatHoldsIt) {
    const glm::dmat4 before = stageFromWorldBefore({{0, 1.6, 0}, {1, 0, 0, 0}}, kSeen);
    const Pose then = turned({0.3, 1.2, -0.4}, {0, 0, 1}, 20.0);
    const Pose now = turned({0.1, 1.4, -0.6}, {1, 2, 0}, 70.0);
    const glm::dmat4 after = followingHand(before, then, now);
    EXPECT_NEAR(scaleOf(after), 1.0, 1e-9);
    // Where it was held, it is held.
    const glm::dvec3 heldMm = transformPoint(glm::inverse(before), then.positionM);
    expectNear(transformPoint(after, heldMm), now.positionM);
    // In the frame of the hand nothing moved.
    const glm::dvec3 some(40, -20, 90);
    expectNear(transformPoint(glm::inverse(stageFromPose(then)) * before, some),
               transformPoint(glm::inverse(stageFromPose(now)) * after, some));
}

TEST(Placement, TwoHandsMoveTurnAndScale) {
    const glm::dmat4 before = stageFromWorldBefore({{0, 1.6, 0}, {1, 0, 0, 0}}, kSeen);
    const std::array<Pose, 2> then{Pose{{-0.1, 1.2, -0.5}, {1, 0, 0, 0}},
                                   Pose{{0.1, 1.2, -0.5}, {1, 0, 0, 0}}};
    // Twice as far apart, and a quarter of a turn about up: the right hand is farther away.
    const std::array<Pose, 2> now{Pose{{0.3, 1.3, -0.3}, {1, 0, 0, 0}}, Pose{{0.3, 1.3, -0.7}, {1, 0, 0, 0}}};
    const glm::dmat4 after = followingHands(before, then, now);
    EXPECT_NEAR(scaleOf(after), 2.0, 1e-9);
    for (std::size_t hand = 0; hand < 2; ++hand) {
        const glm::dvec3 heldMm = transformPoint(glm::inverse(before), then[hand].positionM);
        expectNear(transformPoint(after, heldMm), now[hand].positionM);
    }
    EXPECT_NEAR(transformVector(after, {0, 0, 1}).y, 2e-3, 1e-9) << "still upright";
}

TEST(Placement, TheNearPlaneIsACentimetreOfTheRoom) {
    glm::dmat4 placed = stageFromWorldBefore({{0, 1.6, 0}, {1, 0, 0, 0}}, kSeen);
    EXPECT_NEAR(nearMmOf(placed), 10.0, 1e-9);
    for (int axis = 0; axis < 3; ++axis) placed[axis] *= 20.0;
    EXPECT_NEAR(nearMmOf(placed), 0.5, 1e-9);
}

TEST(Placement, ScaleHasItsLimits) {
    const glm::dmat4 before = stageFromWorldBefore({{0, 1.6, 0}, {1, 0, 0, 0}}, kSeen);
    const auto apart = [](double metres) {
        return std::array<Pose, 2>{Pose{{-0.5 * metres, 1.2, -0.5}, {1, 0, 0, 0}},
                                   Pose{{0.5 * metres, 1.2, -0.5}, {1, 0, 0, 0}}};
    };
    EXPECT_NEAR(scaleOf(followingHands(before, apart(0.03), apart(2.0))), kMostScale, 1e-9);
    EXPECT_NEAR(scaleOf(followingHands(before, apart(1.5), apart(0.03))), kLeastScale, 1e-9);
    // Hands in one place do not tell how they turn.
    EXPECT_NEAR(scaleOf(followingHands(before, apart(0.0), apart(1.0))), 1.0, 1e-9);
    EXPECT_NEAR(scaleOf(followingHands(before, apart(1.0), apart(0.0))), 1.0, 1e-9);
    // Half a turn: hands have crossed.
    std::array<Pose, 2> crossed = apart(0.4);
    std::swap(crossed[0], crossed[1]);
    const glm::dmat4 after = followingHands(before, apart(0.4), crossed);
    EXPECT_NEAR(scaleOf(after), 1.0, 1e-9);
    EXPECT_GT(glm::determinant(glm::dmat3(after)), 0.0);
}

TEST(Placement, TheKnifeRemovesWhatIsToItsRight) {
    const glm::dmat4 placed = stageFromWorldBefore({{0, 1.6, 0}, {1, 0, 0, 0}}, kSeen);
    const glm::dmat4 worldFromStage = glm::inverse(placed);
    const Pose knife{{0.05, 1.5, -0.6}, {1, 0, 0, 0}};
    const HalfSpace kept = keptBeside(knife, worldFromStage);
    Clip clip;
    clip.planes = {kept};
    ASSERT_TRUE(validate(clip).ok());
    EXPECT_TRUE(shows(clip, transformPoint(worldFromStage, knife.positionM + glm::dvec3(-0.01, 0.3, 0.2))));
    EXPECT_FALSE(shows(clip, transformPoint(worldFromStage, knife.positionM + glm::dvec3(0.01, 0.3, 0.2))));
    // The patient's left is at the right.
    EXPECT_NEAR(kept.normal.x, -1.0, 1e-9);
}

}  // namespace
}  // namespace macula::xr
