// From where is looked: distances and targets as the protocol has them, even over the sphere, the same each
// time.
#include "pipeline/hybrid/views/pose_sampling.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace macula::hybrid {
namespace {

const Box kBox{{-120.0, 40.0, 300.0}, {80.0, 190.0, 900.0}};
const double kRadius = 0.5 * kBox.diagonal();

std::vector<SampledPose> sample(const PoseSampling& sampling, const PoseAcceptance& accept = {}) {
    auto views = samplePoses(kBox, sampling, accept);
    EXPECT_TRUE(views.ok());
    return std::move(views).value();
}

TEST(PoseSampling, NoTrialLearnsFromWhereModelsAreJudged) {
    for (std::uint64_t trial : {0, 1, 734, 735, 736, 1 << 20}) {
        EXPECT_NE(initialTraining(1, trial).seed, groundTruth(1).seed) << trial;
        EXPECT_NE(initialTraining(1, trial).seed, wholeFrames(1).seed) << trial;
        EXPECT_NE(initialTraining(1, trial).seed, initialTraining(1, trial + 1).seed) << trial;
        EXPECT_GT(otherSides(1, trial).seed, initialTraining(1, 1u << 20).seed) << trial;
    }
    EXPECT_EQ(initialTraining(1, 0).seed, 42u);
}

TEST(PoseSampling, TheFirstViewLooksAtTheCentreFromTheStartDistance) {
    const std::array<std::pair<PoseSampling, double>, 4> sets{{{initialTraining(1), 5.5},
                                                               {initialTraining(1, 3), 5.5},
                                                               {groundTruth(1), 3.0},
                                                               {extension(1), 4.0}}};
    for (const auto& [sampling, distance] : sets) {
        const SampledPose view = sample(sampling).front();
        EXPECT_NEAR(glm::distance(view.camera.positionMm, kBox.centre()) / kRadius, distance, 1e-12);
        EXPECT_EQ(view.camera.targetMm, kBox.centre());
        EXPECT_EQ(view.camera.verticalFovDeg, 20.0);
        EXPECT_EQ(view.tries, 1);
        EXPECT_TRUE(view.accepted);
    }
}

TEST(PoseSampling, LaterViewsComeNearerAndWanderAsFarAsTheirVariability) {
    for (const PoseSampling& sampling :
         {initialTraining(64), groundTruth(32), wholeFrames(32), extension(256)}) {
        const auto views = sample(sampling);
        double widest = 0.0;  // of the target, in parts of what is allowed
        for (std::size_t i = 0; i < views.size(); ++i) {
            const double v = std::min(double(i) * sampling.increment, sampling.mostVariability);
            const double target = glm::distance(views[i].camera.targetMm, kBox.centre()) / kRadius;
            const double eye = glm::distance(views[i].camera.positionMm, kBox.centre()) / kRadius;
            EXPECT_LE(target, 0.8 * v + 1e-12);
            EXPECT_LE(std::abs(eye - (sampling.startDistance - v)), 0.4 * v + 1e-12);
            if (v > 0.0) widest = std::max(widest, target / (0.8 * v));
        }
        EXPECT_GT(widest, 0.8);  // of 31 and more even in a ball: none is a chance of 0.512^31
    }
    // Nearer than the box's corners in the end, and never at a variability beyond the most.
    const auto views = sample(groundTruth(32));
    EXPECT_LT(glm::distance(views.back().camera.positionMm, kBox.centre()), 2.4 * kRadius + 1e-9);
}

// In height and azimuth an octant of the sphere is an elementary interval: it has its share exactly.
TEST(PoseSampling, DirectionsAreEvenOverTheSphere) {
    PoseSampling sampling = groundTruth(256);
    sampling.increment = 0.0;
    for (sampling.seed = 0; sampling.seed < 4; ++sampling.seed) {
        std::array<int, 8> octants{};
        glm::dvec3 mean(0.0);
        for (const SampledPose& view : sample(sampling)) {
            const glm::dvec3 d = (view.camera.positionMm - kBox.centre()) / (3.0 * kRadius);
            ++octants[(d.x > 0 ? 1u : 0u) + (d.y > 0 ? 2u : 0u) + (d.z > 0 ? 4u : 0u)];
            mean += d / 256.0;
        }
        for (const int count : octants) EXPECT_EQ(count, 32);
        EXPECT_LT(glm::length(mean), 0.01);  // of chance 0.06 would be usual
    }
}

TEST(PoseSampling, IsTheSameEachTimeAndOtherForAnotherSeed) {
    const auto a = sample(initialTraining(16));
    const auto b = sample(initialTraining(16));
    const auto c = sample(initialTraining(16, 1));
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].camera.positionMm, b[i].camera.positionMm);
        EXPECT_EQ(a[i].camera.targetMm, b[i].camera.targetMm);
        EXPECT_NE(a[i].camera.positionMm, c[i].camera.positionMm);
    }
}

TEST(PoseSampling, GoesWithTheBox) {
    const glm::dvec3 away(1e5, -2e5, 3e5);
    const auto views = sample(extension(8));
    const auto moved = samplePoses({kBox.low + away, kBox.high + away}, extension(8));
    ASSERT_TRUE(moved.ok());
    for (std::size_t i = 0; i < views.size(); ++i)
        EXPECT_LT(glm::distance((*moved)[i].camera.positionMm, views[i].camera.positionMm + away), 1e-6);
}

TEST(PoseSampling, TriesAgainUntilAViewIsAccepted) {
    int asked = 0;
    std::vector<glm::dvec3> seen;
    const auto views = sample(groundTruth(5), [&](const Camera& camera) -> Result<bool> {
        seen.push_back(camera.positionMm);
        return ++asked % 3 == 0;
    });
    ASSERT_EQ(views.size(), 5u);
    EXPECT_EQ(asked, 15);
    for (std::size_t i = 0; i < views.size(); ++i) {
        EXPECT_EQ(views[i].tries, 3);
        EXPECT_TRUE(views[i].accepted);
        EXPECT_EQ(views[i].camera.positionMm, seen[3 * i + 2]);
        EXPECT_NE(seen[3 * i], seen[3 * i + 1]);
    }
    // What was not accepted does not count: the second view is as far out as it would have been.
    const double v = 0.05;
    const double eye = glm::distance(views[1].camera.positionMm, kBox.centre()) / kRadius;
    EXPECT_LE(std::abs(eye - (3.0 - v)), 0.4 * v + 1e-12);
}

TEST(PoseSampling, GivesUpAndSaysSo) {
    int asked = 0;
    const auto views = sample(groundTruth(2), [&](const Camera&) -> Result<bool> { return ++asked > 200; });
    EXPECT_EQ(views[0].tries, 200);
    EXPECT_FALSE(views[0].accepted);
    EXPECT_TRUE(views[1].accepted);
    const auto failed = samplePoses(kBox, groundTruth(2), [](const Camera&) -> Result<bool> {
        return Error{ErrorCode::cancelled, Text("Stopped."), {}, {}};
    });
    ASSERT_FALSE(failed.ok());
    EXPECT_EQ(failed.error().code, ErrorCode::cancelled);
}

TEST(PoseSampling, EveryCameraIsUsableAndSuperiorIsUp) {
    for (const SampledPose& view : sample(extension(4096))) {
        const auto axes = basis(view.camera);
        ASSERT_TRUE(axes.ok());
        EXPECT_GE(axes->up.z, 0.0);
    }
}

TEST(PoseSampling, AlongTheBodyAnteriorIsUp) {
    const glm::dvec3 superior{0, 0, 1};
    const glm::dvec3 anterior{0, -1, 0};
    EXPECT_EQ(upFor({0, 0, -1}), anterior);
    EXPECT_EQ(upFor({0, 0, 1}), anterior);
    EXPECT_EQ(upFor(glm::normalize(glm::dvec3{5e-4, 5e-4, -1})), anterior);
    EXPECT_EQ(upFor(glm::normalize(glm::dvec3{2e-3, 0, 1})), superior);
    EXPECT_EQ(upFor({1, 0, 0}), superior);
    for (const glm::dvec3 forward : {glm::dvec3{0, 0, -1}, glm::normalize(glm::dvec3{1.1e-3, 0, 1})})
        EXPECT_TRUE(basis({.positionMm = -forward, .targetMm = {}, .up = upFor(forward)}).ok());
}

TEST(PoseSampling, NothingToLookAtIsAnError) {
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    for (const Box& box : {Box{glm::dvec3(kInfinite), glm::dvec3(-kInfinite)}, Box{{1, 1, 1}, {1, 1, 1}},
                           Box{{0, 0, 0}, {1, -1, 1}}, Box{{0, 0, 0}, {1, kInfinite, 1}},
                           Box{{0, 0, 0}, {1, std::numeric_limits<double>::quiet_NaN(), 1}}}) {
        const auto views = samplePoses(box, groundTruth(1));
        ASSERT_FALSE(views.ok());
        EXPECT_EQ(views.error().code, ErrorCode::usage);
    }
    PoseSampling bad = groundTruth(1);
    bad.verticalFovDeg = 0.0;
    EXPECT_FALSE(samplePoses(kBox, bad).ok());
    bad = groundTruth(1);
    bad.startDistance = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(samplePoses(kBox, bad).ok());
}

}  // namespace
}  // namespace macula::hybrid
