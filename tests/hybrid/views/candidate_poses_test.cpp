// From where a new picture would teach most.
#include "pipeline/hybrid/views/candidate_poses.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/hybrid/views/pose_sampling.h"

namespace macula::hybrid {
namespace {

const glm::dvec3 kCentre(30.0, -20.0, 1000.0);
const glm::dvec3 kOrigin(5.0, 6.0, 900.0);
const Box kBox{kCentre - glm::dvec3(100.0), kCentre + glm::dvec3(100.0)};
constexpr double kFarMm = 900.0;

KnownPose seenFrom(const glm::dvec3& direction, double error, double fovDeg = 20.0,
                   const glm::dvec3& target = kCentre) {
    const glm::dvec3 eye = kCentre + kFarMm * glm::normalize(direction);
    const Camera camera{.positionMm = eye,
                        .targetMm = target,
                        .up = upFor(glm::normalize(target - eye)),
                        .verticalFovDeg = fovDeg};
    return {.view = *splat::rasterView(camera, {256, 256}, kOrigin), .error = error};
}

glm::dvec3 from(const CandidatePose& view) {
    return glm::normalize(view.camera.positionMm - kCentre);
}

std::vector<CandidatePose> wanted(const std::vector<KnownPose>& known, std::uint64_t seed = 1) {
    return candidatePoses(known, kBox, kOrigin, seed).value();
}

TEST(WantedViews, AreFromTheOtherSide) {
    std::vector<KnownPose> known;
    for (const double z : {-0.3, 0.0, 0.3})
        for (const double x : {-0.3, 0.0, 0.3}) known.push_back(seenFrom({x, -1.0, z}, 0.1));
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        const auto views = wanted(known, seed);
        ASSERT_GT(views.size(), 50u);
        EXPECT_GT(from(views.front()).y, 0.8);
        EXPECT_LT(from(views.back()).y, -0.7);
        for (std::size_t i = 1; i < views.size(); ++i)
            EXPECT_LE(views[i].expectedError, views[i - 1].expectedError);
    }
}

TEST(WantedViews, AreWhereTheModelIsWorse) {
    // From six sides; the patient's left is four times as wrong.
    std::vector<KnownPose> known;
    for (const double sign : {-1.0, 1.0})
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 direction(0.0);
            direction[axis] = sign;
            known.push_back(seenFrom(direction, axis == 0 && sign > 0 ? 0.4 : 0.1));
        }
    const auto views = wanted(known);
    EXPECT_GT(from(views.front()).x, 0.5);
    double worst = 0.0;
    for (std::size_t i = 0; i < 5; ++i) worst += from(views[i]).x / 5.0;
    EXPECT_GT(worst, 0.5);
}

TEST(WantedViews, ANarrowViewKnowsOnlyWhatItShows) {
    // A foveal picture of 4 degrees from the front, beside all that is asked for, and everything else wide.
    std::vector<KnownPose> known;
    for (const glm::dvec3 d : {glm::dvec3(0, 1, 0), glm::dvec3(1, 0, 0), glm::dvec3(-1, 0, 0),
                               glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1)})
        known.push_back(seenFrom(d, 0.1));
    known.push_back(seenFrom({0, -1, 0}, 0.1, 4.0, kCentre + glm::dvec3(0, 0, 90)));
    EXPECT_LT(from(wanted(known).front()).y, -0.6);
    known.back() = seenFrom({0, -1, 0}, 0.1);
    EXPECT_GT(from(wanted(known).front()).y, -0.9) << "a wide one from there shows it all";
}

TEST(WantedViews, AreNeverOfAPoseThatIsKnownAndAreAFunctionOfTheSeed) {
    std::vector<KnownPose> known;
    std::vector<glm::dvec3> asked;
    for (std::uint64_t i = 0; i < 60; ++i) {
        const auto views = wanted(known, i);
        ASSERT_FALSE(views.empty());
        const KnownPose next{.view = *splat::rasterView(views.front().camera, {512, 512}, kOrigin),
                             .error = 0.1};
        for (const KnownPose& k : known)
            EXPECT_FALSE(isSamePose(k.view, next.view, 0.5 * kBox.diagonal())) << i;
        known.push_back(next);
        asked.push_back(views.front().camera.positionMm);
        EXPECT_EQ(wanted({known.begin(), known.end() - 1}, i).front().camera.positionMm, asked.back());
    }
    // Together they see every side: no direction is farther than 40 degrees from one of them.
    const auto others = samplePoses(kBox, groundTruth(200));
    for (const SampledPose& any : *others) {
        double nearest = -1.0;
        for (const glm::dvec3& eye : asked)
            nearest = std::max(nearest, glm::dot(glm::normalize(eye - kCentre),
                                                 glm::normalize(any.camera.positionMm - kCentre)));
        EXPECT_GT(nearest, std::cos(glm::radians(40.0)));
    }
    EXPECT_NE(wanted({}, 1).front().camera.positionMm, wanted({}, 2).front().camera.positionMm);
    EXPECT_EQ(candidatePoses({}, Box{}, kOrigin, 1).error().code, ErrorCode::usage);
}

}  // namespace
}  // namespace macula::hybrid
