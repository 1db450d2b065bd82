// A spine that fits itself one vertebra off: the answer may be wrong, and then doubt is told.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "moved_volumes.h"
#include "registration/rigid_registration.h"
#include "spine_phantom.h"

namespace macula::registration::test {
namespace {

RigidRegistration registered(const Volume& fixed, const Volume& moving) {
    Progress progress;
    const auto found = registerRigid(fixed, moving, progress);
    EXPECT_TRUE(found.ok()) << (found ? "" : found.error().message.english());
    return found ? *found : RigidRegistration{};
}

// Of the prior, whose scanner has another origin.
const glm::dmat4 kMoved = rigid(2.0, {4.0, -7.0, 340.0});
constexpr Trunk kOfThePrior{.seed = 77};

Trunk prior(Trunk trunk) {
    trunk.seed = kOfThePrior.seed;
    return trunk;
}

std::string textOf(const RigidRegistration& found) {
    return fmt::format("bound {} mm, rival {} at {} mm, information {}, overlap {}", found.boundMm,
                       found.rivalShare, found.rivalMm, found.informationAfter, found.overlap);
}

// The prior shows another part of the spine, so no answer is right. What is found is sharp, and vertebrae
// off.
TEST(Rival, AWrongAnswerIsDoubtful) {
    for (const auto& [differsBy, lowMm] : {std::pair(0.0, 126.0), {0.01, 130.0}}) {
        const Trunk trunk{.differsBy = differsBy};
        const auto fixed = trunkScan(trunk, -105.0, 105.0);
        const auto moving = trunkScan(prior(trunk), lowMm, lowMm + 150.0, kMoved);
        const RigidRegistration found = registered(*fixed, *moving);
        EXPECT_GT(errorMm(found.movingFromFixed, kMoved), 20.0) << "there was nothing to doubt";
        EXPECT_LT(found.boundMm, 3.0) << "the bound tells nothing of it";
        EXPECT_TRUE(found.hasRival()) << textOf(found);
        EXPECT_TRUE(found.isDoubtful()) << textOf(found);
    }
}

// Whichever was found: nothing but the ends of the spine says which of both is right.
TEST(Rival, AVertebraThatIsNearlyTheNextIsDoubtful) {
    for (const double differsBy : {0.0, 0.005, 0.01}) {
        const Trunk trunk{.differsBy = differsBy};
        const auto fixed = trunkScan(trunk, -105.0, 105.0);
        const auto moving = trunkScan(prior(trunk), -60.0, 150.0, kMoved);
        const RigidRegistration found = registered(*fixed, *moving);
        EXPECT_TRUE(found.hasRival()) << textOf(found);
        EXPECT_TRUE(found.isDoubtful()) << textOf(found);
        const double vertebrae = found.rivalMm / kVertebraMm;
        EXPECT_NEAR(vertebrae, std::round(vertebrae), 0.15) << textOf(found);
    }
}

TEST(Rival, CervicalVertebraeAreTooNarrowForTheCoarsestCells) {
    const Trunk trunk{.differsBy = 0.005, .vertebraMm = 18.0};
    const auto fixed = trunkScan(trunk, -80.0, 80.0);
    const auto moving = trunkScan(prior(trunk), -50.0, 110.0, kMoved);
    EXPECT_TRUE(registered(*fixed, *moving).hasRival());
}

TEST(Rival, WhatFitsInOnePlaceAloneIsNotDoubtful) {
    const Trunk trunk{.differsBy = 0.01, .hasOrgans = true};
    const auto fixed = trunkScan(trunk, -150.0, 130.0);
    for (const auto& [low, high] : {std::pair{-150.0, 130.0}, {-90.0, 190.0}, {-120.0, 90.0}}) {
        const auto moving = trunkScan(prior(trunk), low, high, kMoved);
        const RigidRegistration found = registered(*fixed, *moving);
        EXPECT_LT(errorMm(found.movingFromFixed, kMoved), 3.0);
        EXPECT_FALSE(found.hasRival()) << textOf(found);
        EXPECT_FALSE(found.isDoubtful()) << textOf(found);
    }
}

}  // namespace
}  // namespace macula::registration::test
