// Volumes whose true place is known: the phantom, moved.
#include "registration/rigid_registration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "moved_volumes.h"

namespace macula::registration::test {
namespace {

constexpr double kHalfAVoxelMm = 2.1;  // of the phantom below

const Volume& fixedPhantom() {
    static const Volume made = phantom::make(coarsePhantom());
    return made;
}

RigidRegistration registered(const Volume& fixed, const Volume& moving) {
    Progress progress;
    const auto found = registerRigid(fixed, moving, progress);
    EXPECT_TRUE(found.ok()) << (found ? "" : found.error().message.english());
    return found ? *found : RigidRegistration{};
}

Error errorOf(const Volume& fixed, const Volume& moving) {
    Progress progress;
    const auto found = registerRigid(fixed, moving, progress);
    EXPECT_FALSE(found.ok());
    return found ? Error{} : found.error();
}

Volume filled(const glm::ivec3& size, float value) {
    auto volume = Volume::createFloat(
        {.size = size, .worldFromVoxel = affine({4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {0, 0, 0})},
        std::vector<float>(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z), value));
    return *std::move(volume);
}

TEST(RigidRegistration, AVolumeThatWasMovedBy12MmAnd7DegreesIsFoundToHalfAVoxel) {
    const glm::dmat4 truth = rigid(7.0, {7.0, -6.0, 7.6});  // 12 mm
    const auto moving = scanOf(straightScan(), truth);
    const RigidRegistration found = registered(fixedPhantom(), *moving);
    EXPECT_LT(errorMm(found.movingFromFixed, truth), kHalfAVoxelMm);
    EXPECT_GT(errorMm(glm::dmat4(1.0), truth), 4.0 * kHalfAVoxelMm) << "there was nothing to find";
    EXPECT_TRUE(isRigid(found.movingFromFixed));
    EXPECT_GT(found.informationAfter, found.informationBefore);
    EXPECT_LT(found.boundMm, kHalfAVoxelMm);
    EXPECT_GT(found.overlap, 0.7);
    EXPECT_FALSE(found.isDoubtful());
}

TEST(RigidRegistration, AVolumeLiesInItself) {
    const RigidRegistration found = registered(fixedPhantom(), fixedPhantom());
    EXPECT_LT(errorMm(found.movingFromFixed, glm::dmat4(1.0)), 0.5);
}

TEST(RigidRegistration, TheSameVolumesGiveTheSameBits) {
    const auto moving = scanOf(straightScan(), rigid(3.0, {5.0, 2.0, -4.0}));
    EXPECT_EQ(registered(fixedPhantom(), *moving), registered(fixedPhantom(), *moving));
}

// Fat is bright, bone and air are dark: no line leads from one to the other.
TEST(RigidRegistration, AnotherKindOfPictureIsFoundToAVoxel) {
    Scan scan = straightScan();
    scan.unit = Unit::raw;
    scan.scanner = [](double hu) {
        if (hu < -500.0) return 20.0;
        if (hu < 0.0) return 900.0;
        return hu < 200.0 ? 400.0 : 120.0;
    };
    const glm::dmat4 truth = rigid(5.0, {-6.0, 4.0, 9.0});
    const RigidRegistration found = registered(fixedPhantom(), *scanOf(scan, truth));
    EXPECT_LT(errorMm(found.movingFromFixed, truth), 2.0 * kHalfAVoxelMm);
    EXPECT_FALSE(found.isDoubtful());
}

// Uptake in soft tissue, much of it in muscle of the heart, none in air.
TEST(RigidRegistration, PetIsFoundToAVoxel) {
    Scan scan = straightScan();
    scan.unit = Unit::suvBodyWeight;
    scan.scanner = [](double hu) {
        if (hu < -500.0) return 0.15;
        return hu > 90.0 && hu < 130.0 ? 4.0 : 0.9;
    };
    const glm::dmat4 truth = rigid(4.0, {3.0, -8.0, 5.0});
    const RigidRegistration found = registered(fixedPhantom(), *scanOf(scan, truth));
    EXPECT_LT(errorMm(found.movingFromFixed, truth), 2.0 * kHalfAVoxelMm);
}

TEST(RigidRegistration, ATiltedGantryIsNoObstacle) {
    const glm::dmat4 truth = rigid(6.0, {4.0, 3.0, -8.0});
    const RigidRegistration found = registered(fixedPhantom(), *scanOf(straightScan(18.0), truth));
    EXPECT_LT(errorMm(found.movingFromFixed, truth), kHalfAVoxelMm);
}

// A prior that shows the upper half only, from a scanner whose origin lies elsewhere.
TEST(RigidRegistration, APartOfTheBodyIsFoundWhereItIs) {
    Scan scan = straightScan();
    scan.size.z = 26;
    const glm::dmat4 truth = rigid(2.0, {15.0, -10.0, 160.0});
    scan.worldFromVoxel[3] += glm::dvec4(15.0, -10.0, 230.0, 0.0);
    const RigidRegistration found = registered(fixedPhantom(), *scanOf(scan, truth));
    EXPECT_LT(errorMm(found.movingFromFixed, truth), 2.0 * kHalfAVoxelMm);
}

TEST(RigidRegistration, WhatHasNothingToGoByIsAnErrorThatSaysSo) {
    constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
    const auto has = [](const Error& error, const char* words) {
        EXPECT_EQ(error.code, ErrorCode::inputNotUsable);
        EXPECT_NE(error.message.english().find(words), std::string::npos) << error.message;
        EXPECT_FALSE(error.hint.empty());
    };
    const glm::ivec3 some(24);
    has(errorOf(fixedPhantom(), filled(some, 3.0F)), "the same value everywhere");
    has(errorOf(filled(some, 3.0F), fixedPhantom()), "the same value everywhere");
    has(errorOf(fixedPhantom(), filled(some, kNaN)), "no values");
    has(errorOf(filled(some, kNaN), filled(some, kNaN)), "no values");
    has(errorOf(fixedPhantom(), filled(glm::ivec3(1), 3.0F)), "fewer than three");
    has(errorOf(filled({64, 64, 2}, 3.0F), fixedPhantom()), "fewer than three");
    has(errorOf(filled(glm::ivec3(4), 3.0F), fixedPhantom()), "the same value everywhere");
}

TEST(RigidRegistration, FourVoxelsEachWayAreTooFew) {
    const glm::ivec3 size(4);
    std::vector<float> voxels;
    for (int n = 0; n < 64; ++n) voxels.push_back(float(n % 7));
    const auto tiny = Volume::createFloat({.size = size}, voxels);
    EXPECT_NE(errorOf(*tiny, fixedPhantom()).message.english().find("too few voxels"), std::string::npos);
    EXPECT_NE(errorOf(fixedPhantom(), *tiny).message.english().find("too few voxels"), std::string::npos);
}

TEST(RigidRegistration, WhoCancelsIsObeyed) {
    const CancelToken token;
    token.cancel();
    Progress progress({}, token);
    const auto found = registerRigid(fixedPhantom(), fixedPhantom(), progress);
    ASSERT_FALSE(found.ok());
    EXPECT_EQ(found.error().code, ErrorCode::cancelled);
}

TEST(RigidRegistration, ProgressGoesOnToTheEnd) {
    double last = -1.0;
    Progress progress([&](const ProgressUpdate& update) {
        EXPECT_GE(update.fraction, last);
        last = update.fraction;
    });
    ASSERT_TRUE(registerRigid(fixedPhantom(), fixedPhantom(), progress).ok());
    EXPECT_DOUBLE_EQ(last, 1.0);
}

TEST(RigidRegistration, DoubtIsTold) {
    RigidRegistration sure;
    sure.informationBefore = 0.2;
    sure.informationAfter = 0.6;
    sure.overlap = 0.8;
    sure.boundMm = 0.5;
    EXPECT_FALSE(sure.isDoubtful());
    auto doubtful = [&](auto change) {
        RigidRegistration changed = sure;
        change(changed);
        return changed.isDoubtful();
    };
    EXPECT_TRUE(doubtful([](auto& r) { r.boundMm = 8.0; }));
    EXPECT_TRUE(doubtful([](auto& r) { r.boundMm = std::numeric_limits<double>::quiet_NaN(); }));
    EXPECT_TRUE(doubtful([](auto& r) { r.informationAfter = 0.1; }));
    EXPECT_TRUE(doubtful([](auto& r) { r.overlap = 0.01; }));
}

TEST(BoxOverlap, IsTheShareOfTheFirst) {
    const Volume cube = filled(glm::ivec3(24), 1.0F);
    EXPECT_DOUBLE_EQ(boxOverlap(cube, cube, glm::dmat4(1.0)), 1.0);
    EXPECT_DOUBLE_EQ(boxOverlap(cube, cube, rigid(0.0, {48.0, 0.0, 0.0})), 0.5);
    EXPECT_DOUBLE_EQ(boxOverlap(cube, cube, rigid(0.0, {500.0, 0.0, 0.0})), 0.0);
}

TEST(IsRigid, NothingElseIs) {
    EXPECT_TRUE(isRigid(rigid(33.0, {1.0, 2.0, 3.0})));
    EXPECT_FALSE(isRigid(affine({-1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}))) << "a mirror";
    EXPECT_FALSE(isRigid(affine({1.1, 0, 0}, {0, 1.1, 0}, {0, 0, 1.1}, {0, 0, 0}))) << "larger";
    EXPECT_FALSE(isRigid(affine({1, 0, 0}, {0, 1, 0}, {0, 0.2, 1}, {0, 0, 0}))) << "sheared";
    glm::dmat4 broken(1.0);
    broken[3][1] = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(isRigid(broken));
    EXPECT_FALSE(isRigid(glm::dmat4(0.0)));
}

}  // namespace
}  // namespace macula::registration::test
