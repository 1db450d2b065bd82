#include "scene/clip/edited_clip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "base/phantom.h"
#include "scene/choice/clip_choice.h"

namespace macula::scene {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

Volume volumeOf(const glm::ivec3& size, const glm::dmat4& worldFromVoxel) {
    auto volume = Volume::create({.size = size, .worldFromVoxel = worldFromVoxel},
                                 std::vector<std::uint16_t>(std::size_t(size.x * size.y * size.z), 1));
    EXPECT_TRUE(volume);
    return *std::move(volume);
}

// x from -101 to -81, y from 49 to 89, z from 999 to 1059.
Volume straight() {
    return volumeOf({10, 20, 30}, affine({2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {-100, 50, 1000}));
}

std::vector<Volume> allKinds() {
    std::vector<Volume> volumes;
    volumes.push_back(straight());
    volumes.push_back(phantom::make({.size = {12, 10, 8}, .spacingMm = {20, 20, 25}}));
    volumes.push_back(volumeOf({6, 5, 4}, affine({1, 1, 0}, {-1, 1, 0.5}, {0, 1, 2}, {7, 8, 9})));
    volumes.push_back(volumeOf({8, 8, 1}, affine({-1, 0, 0}, {0, 0, 1}, {0, 5, 0}, {0, 0, 0})));
    volumes.push_back(volumeOf({1, 1, 1}, affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0})));
    volumes.push_back(volumeOf({1, 1, 1}, affine({1, 1, 0}, {-1, 1, 0}, {0, 0.1, 3}, {1e5, 1e5, 1e5})));
    volumes.push_back(volumeOf({9, 9, 9}, affine({1e-3, 0, 0}, {0, 1e-3, 0}, {0, 0, 1e-3}, {5, 5, 5})));
    return volumes;
}

// Within the volume, with at least a voxel between faces, and the same when it was written and read.
void expectUsable(const OptionalClip& clip, const Volume& volume) {
    const Box all = volume.worldBox();
    const double tiny = 1e-9 * (glm::length(all.low) + glm::length(all.high) + all.diagonal());
    const Result<Box> kept = keptBox(clip, volume);
    ASSERT_TRUE(kept) << kept.error().message;
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(kept->low[axis], all.low[axis]);
        EXPECT_LE(kept->high[axis], all.high[axis]);
        EXPECT_GE(kept->high[axis] - kept->low[axis], voxelExtentMm(volume)[axis] - tiny);
    }
    if (!clip) return;
    EXPECT_TRUE(validate(clipFor(*clip, volume)));
    const auto read = clipPresetFromJson(toJson(*clip), "test");
    ASSERT_TRUE(read) << read.error().message << " " << read.error().hint << "\n" << toJson(*clip);
    EXPECT_TRUE(validate(clipFor(*read, volume)));
    EXPECT_EQ(read->name, kOwnClipName);
    const Result<Box> again = keptBox(*read, volume);
    ASSERT_TRUE(again);
    for (const Face face : kFaces) EXPECT_NEAR(faceMm(*again, face), faceMm(*kept, face), tiny);
}

void expectRefused(const Result<OptionalClip>& edited) {
    ASSERT_FALSE(edited);
    EXPECT_EQ(edited.error().code, ErrorCode::usage);
    EXPECT_FALSE(edited.error().message.empty());
    EXPECT_FALSE(edited.error().hint.empty());
}

class Chance {
  public:
    double in(double low, double high) { return low + (high - low) * double(bits_()) / double(bits_.max()); }
    int below(int count) { return int(bits_() % unsigned(count)); }
    // Now and then far outside of the volume.
    glm::dvec3 around(const Box& box) {
        const glm::dvec3 size = box.high - box.low;
        const double reach = below(3) == 0 ? 2.0 : 0.0;
        glm::dvec3 point;
        for (int axis = 0; axis < 3; ++axis)
            point[axis] = in(box.low[axis] - reach * size[axis], box.high[axis] + reach * size[axis]);
        return point;
    }

  private:
    std::mt19937 bits_{20240611};
};

Result<OptionalClip> anyEdit(const OptionalClip& clip, const Volume& volume, Chance& chance) {
    const glm::dvec3 at = chance.around(volume.worldBox());
    const double sizeMm = chance.in(0.0, 2.0 * volume.worldBox().diagonal());
    const Face face = kFaces.at(std::size_t(chance.below(6)));
    switch (chance.below(7)) {
        case 0:
            return withFace(clip, face, chance.below(9) == 0 ? 1e300 : at[axisOf(face)], volume);
        case 1:
            return withFaceOpen(clip, face, volume);
        case 2:
            return withSideRemoved(clip, face, at, volume);
        case 3:
            return withSlabKept(clip, slices::Orientation(chance.below(3)), at, sizeMm, volume);
        case 4:
            return withCornerRemoved(clip,
                                     {faceOf(0, chance.below(2) == 0), faceOf(1, chance.below(2) == 0),
                                      faceOf(2, chance.below(2) == 0)},
                                     at, volume);
        case 5:
            return withBallRemoved(clip, at, sizeMm, volume);
        default:
            return turnedInsideOut(clip, volume);
    }
}

TEST(EditedClip, StaysUsableWhateverIsDone) {
    Chance chance;
    for (const Volume& volume : allKinds()) {
        OptionalClip clip;
        int done = 0;
        for (int step = 0; step < 300; ++step) {
            const Result<OptionalClip> next = anyEdit(clip, volume, chance);
            if (!next) {
                expectRefused(next);
                continue;
            }
            ++done;
            expectUsable(*next, volume);
            if (testing::Test::HasFailure()) FAIL() << "step " << step;
            clip = chance.below(10) == 0 ? OptionalClip{} : *next;
        }
        EXPECT_GT(done, 30);
    }
}

TEST(EditedClip, AFaceGoesWhereItIsPutOnItsOwnSideOfThePatient) {
    const Volume volume = straight();
    const glm::dvec3 centre = volume.worldBox().centre();
    for (const Face face : kFaces) {
        const int axis = axisOf(face);
        const double sign = isHigh(face) ? 1.0 : -1.0;
        const Result<OptionalClip> clip = withFace(std::nullopt, face, centre[axis] + sign * 5.0, volume);
        ASSERT_TRUE(clip);
        ASSERT_TRUE(*clip);
        EXPECT_NEAR(faceMm(*keptBox(*clip, volume), face), centre[axis] + sign * 5.0, 1e-9);
        glm::dvec3 inside = centre;
        inside[axis] += sign * 4.9;
        glm::dvec3 outside = centre;
        outside[axis] += sign * 5.1;
        EXPECT_TRUE(shows(clipFor(**clip, volume), inside)) << nameOf(face);
        EXPECT_FALSE(shows(clipFor(**clip, volume), outside)) << nameOf(face);
        const Result<OptionalClip> open = withFaceOpen(*clip, face, volume);
        ASSERT_TRUE(open);
        EXPECT_FALSE(*open) << "all of it is shown again";
    }
}

// Patient LPS: left, posterior and superior are positive.
TEST(EditedClip, SidesAreThePatients) {
    const Volume volume = straight();
    const glm::dvec3 centre = volume.worldBox().centre();
    const auto removes = [&](Face side, const glm::dvec3& direction) {
        const Result<OptionalClip> clip = withSideRemoved(std::nullopt, side, centre, volume);
        ASSERT_TRUE(clip);
        EXPECT_FALSE(shows(clipFor(**clip, volume), centre + direction)) << nameOf(side);
        EXPECT_TRUE(shows(clipFor(**clip, volume), centre - direction)) << nameOf(side);
        // The next one of the same kind would do nothing, and the other one leave nothing.
        expectRefused(withSideRemoved(*clip, side, centre, volume));
        expectRefused(withSideRemoved(*clip, faceOf(axisOf(side), !isHigh(side)), centre, volume));
    };
    removes(Face::right, {-1, 0, 0});
    removes(Face::left, {1, 0, 0});
    removes(Face::anterior, {0, -1, 0});
    removes(Face::posterior, {0, 1, 0});
    removes(Face::inferior, {0, 0, -1});
    removes(Face::superior, {0, 0, 1});
}

// The outermost voxels are not for the last bits of a number to decide.
TEST(EditedClip, AnOpenFaceCutsNothing) {
    const Volume volume = straight();
    const Box all = volume.worldBox();
    const auto clip = withFace(std::nullopt, Face::left, all.centre().x, volume);
    ASSERT_TRUE(clip);
    const Clip inMm = clipFor(**clip, volume);
    EXPECT_TRUE(shows(inMm, all.low));
    EXPECT_TRUE(shows(inMm, {all.centre().x - 1.0, all.high.y, all.high.z}));
}

TEST(EditedClip, AFaceStopsAVoxelBeforeTheOther) {
    const Volume volume = straight();
    const Box all = volume.worldBox();
    const auto clip = withFace(std::nullopt, Face::right, 1e300, volume);
    ASSERT_TRUE(clip);
    EXPECT_NEAR(keptBox(*clip, volume)->low.x, all.high.x - 2.0, 1e-9);
    const auto outside = withFace(std::nullopt, Face::right, -1e300, volume);
    ASSERT_TRUE(outside);
    EXPECT_FALSE(*outside);
}

TEST(EditedClip, FacesOfABuiltInClipMoveAndItsWindowStays) {
    const Volume volume = straight();
    const Box all = volume.worldBox();
    const OptionalClip front = *chooseClip("front-open");
    EXPECT_NEAR(keptBox(front, volume)->low.y, all.centre().y, 1e-9);
    const auto moved = withFace(front, Face::left, -85.0, volume);
    ASSERT_TRUE(moved);
    EXPECT_NEAR(keptBox(*moved, volume)->low.y, all.centre().y, 1e-9);
    EXPECT_NEAR(keptBox(*moved, volume)->high.x, -85.0, 1e-9);
    EXPECT_TRUE((*moved)->greyFacesOfSeries);
    EXPECT_TRUE((*moved)->clip.planes.empty()) << "one face, one place";
    // Opened and cut again, as while a slider is drawn: the slice is still on the cut.
    const auto open = withFaceOpen(front, Face::anterior, volume);
    ASSERT_TRUE(open);
    ASSERT_TRUE(*open);
    EXPECT_FALSE((*open)->clip.hasShape());
    const auto again = withFace(*open, Face::anterior, 60.0, volume);
    ASSERT_TRUE(again);
    EXPECT_TRUE((*again)->greyFacesOfSeries);
}

TEST(EditedClip, ASlabHasThePointInItsMiddle) {
    const Volume volume = straight();
    const auto slab = withSlabKept(std::nullopt, slices::Orientation::axial, {-90, 60, 1020}, 10.0, volume);
    ASSERT_TRUE(slab);
    const Box kept = *keptBox(*slab, volume);
    EXPECT_NEAR(kept.low.z, 1015.0, 1e-9);
    EXPECT_NEAR(kept.high.z, 1025.0, 1e-9);
    EXPECT_EQ(kept.low.x, volume.worldBox().low.x);
    EXPECT_NEAR(
        keptBox(*withSlabKept(std::nullopt, slices::Orientation::coronal, {-90, 60, 1020}, 10.0, volume),
                volume)
            ->high.y,
        65.0, 1e-9);
    EXPECT_NEAR(
        keptBox(*withSlabKept(std::nullopt, slices::Orientation::sagittal, {-90, 60, 1020}, 10.0, volume),
                volume)
            ->low.x,
        -95.0, 1e-9);
    // Thinner than a voxel, and at the border.
    const auto thin = withSlabKept(std::nullopt, slices::Orientation::axial, {-90, 60, 999}, 0.01, volume);
    ASSERT_TRUE(thin);
    EXPECT_NEAR(keptBox(*thin, volume)->high.z, 1001.0, 1e-9);
    for (const double thickness : {0.0, -1.0, kNan, kInfinite}) {
        expectRefused(
            withSlabKept(std::nullopt, slices::Orientation::axial, {-90, 60, 1020}, thickness, volume));
    }
    expectRefused(withSlabKept(std::nullopt, slices::Orientation::axial, {-90, 60, 0}, 10.0, volume));
}

TEST(EditedClip, ABallIsTakenOutInMm) {
    const Volume volume = straight();
    const glm::dvec3 centre{-90, 70, 1030};
    const auto clip = withBallRemoved(std::nullopt, centre, 6.0, volume);
    ASSERT_TRUE(clip);
    const Clip inMm = clipFor(**clip, volume);
    for (const glm::dvec3& direction : {glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1)}) {
        EXPECT_FALSE(shows(inMm, centre + 5.99 * direction));
        EXPECT_TRUE(shows(inMm, centre + 6.01 * direction));
    }
    for (const double radius : {0.0, -6.0, kNan, kInfinite, 1e300, 1e-12})
        expectRefused(withBallRemoved(std::nullopt, centre, radius, volume));
    expectRefused(withBallRemoved(std::nullopt, centre, ballRadiiMm(volume).high, volume));  // all of it
    expectRefused(withBallRemoved(std::nullopt, {0, 0, 0}, 6.0, volume));
}

TEST(EditedClip, ACornerIsTakenOut) {
    const Volume volume = straight();
    const glm::dvec3 centre = volume.worldBox().centre();
    const auto clip =
        withCornerRemoved(std::nullopt, {Face::superior, Face::left, Face::anterior}, centre, volume);
    ASSERT_TRUE(clip);
    const Clip inMm = clipFor(**clip, volume);
    EXPECT_FALSE(shows(inMm, centre + glm::dvec3(1, -1, 1)));
    EXPECT_TRUE(shows(inMm, centre + glm::dvec3(-1, -1, 1)));
    EXPECT_TRUE(shows(inMm, centre + glm::dvec3(1, 1, 1)));
    EXPECT_TRUE(shows(inMm, centre + glm::dvec3(1, -1, -1)));
}

// Of a flat volume an oblique plane is never said by a point far outside, which no file may have.
TEST(EditedClip, AnObliquePlaneOfAFlatVolumeCanBeReadAgain) {
    const Volume flat = volumeOf({40, 40, 1}, affine({10, 0, 0}, {0, 10, 0}, {0, 0, 1}, {-195, -195, 0}));
    const Box all = flat.worldBox();
    for (const glm::dvec3& towards : {glm::dvec3(1, 1, 1), glm::dvec3(-1, 2, 3), glm::dvec3(1, 0, 0)}) {
        ClipPreset oblique;
        oblique.clip.planes.push_back({glm::normalize(towards), 0.0});
        oblique.planesAt.emplace_back(0.5);
        for (const double far : {-1.0, -0.7, 0.3, 0.9, 5.0}) {
            const glm::dvec3 to = all.centre() + far * glm::dvec3(150.0, 150.0, 0.0);
            const auto moved = withPlaneThrough(oblique, 0, to, flat);
            ASSERT_TRUE(moved) << moved.error().message;
            const glm::dvec3 at = (*moved)->planesAt.at(0);
            EXPECT_TRUE(glm::all(glm::greaterThanEqual(at, glm::dvec3(0.0)))) << far;
            EXPECT_TRUE(glm::all(glm::lessThanEqual(at, glm::dvec3(1.0)))) << far;
            const auto read = clipPresetFromJson(toJson(**moved), "test");
            ASSERT_TRUE(read) << read.error().message;
            const HalfSpace plane = clipFor(*read, flat).planes.at(0);
            const double wanted = glm::dot(plane.normal, to);
            const double reach = glm::dot(0.5 * (all.high - all.low), glm::abs(plane.normal));
            if (std::abs(wanted - glm::dot(plane.normal, all.centre())) < 0.9 * reach) {
                EXPECT_NEAR(plane.offsetMm, wanted, 1e-6) << far;
            }
        }
    }
}

TEST(EditedClip, InsideOutShowsWhatWasNotShown) {
    const Volume volume = straight();
    const Box all = volume.worldBox();
    Chance chance;
    std::vector<OptionalClip> clips;
    for (const char* name : {"left-half", "slab-axial", "centre-ball", "corner-open", "front-open"})
        clips.emplace_back(*chooseClip(name));
    clips.push_back(*withBallRemoved(std::nullopt, all.centre(), 9.0, volume));
    ClipPreset oblique;
    oblique.clip.planes.push_back({glm::normalize(glm::dvec3(1, 2, 3)), 0.0});
    oblique.planesAt.emplace_back(0.4, 0.5, 0.6);
    clips.emplace_back(oblique);
    for (const OptionalClip& clip : clips) {
        const auto turned = turnedInsideOut(clip, volume);
        ASSERT_TRUE(turned) << clip->name << turned.error().message;
        const auto back = turnedInsideOut(*turned, volume);
        ASSERT_TRUE(back) << clip->name << back.error().message;
        int shown = 0;
        for (int i = 0; i < 500; ++i) {
            const glm::dvec3 point{chance.in(all.low.x, all.high.x), chance.in(all.low.y, all.high.y),
                                   chance.in(all.low.z, all.high.z)};
            const bool was = shows(clipFor(*clip, volume), point);
            shown += was ? 1 : 0;
            EXPECT_NE(shows(clipFor(**turned, volume), point), was) << clip->name;
            EXPECT_EQ(shows(clipFor(**back, volume), point), was) << clip->name;
        }
        EXPECT_GT(shown, 0) << clip->name;
        EXPECT_LT(shown, 500) << clip->name;
    }
}

TEST(EditedClip, InsideOutOfWhatHasNoOtherSideIsRefused) {
    const Volume volume = straight();
    expectRefused(turnedInsideOut(std::nullopt, volume));
    const auto half = withSideRemoved(std::nullopt, Face::left, volume.worldBox().centre(), volume);
    ASSERT_TRUE(half);
    const auto both = withBallRemoved(*half, volume.worldBox().centre(), 5.0, volume);
    ASSERT_TRUE(both);
    expectRefused(turnedInsideOut(*both, volume));
}

// A removed box leaves six planes for the faces.
TEST(EditedClip, FacesBesideARemovedBoxArePlanesUntilThereAreNoMore) {
    const Volume volume = straight();
    ClipPreset preset;
    preset.clip.box = OrientedBox{.centreMm = glm::dvec3(0.5), .halfSizeMm = glm::dvec3(0.1)};
    preset.clip.ofBox = Keep::outside;
    for (int i = 0; i < 5; ++i) {
        preset.clip.planes.push_back({glm::normalize(glm::dvec3(1, 1, 1)), 0.0});
        preset.planesAt.emplace_back(0.01 * i);
    }
    const auto one = withFace(preset, Face::left, -85.0, volume);
    ASSERT_TRUE(one);
    EXPECT_EQ((*one)->clip.planes.size(), Clip::kMostPlanes);
    EXPECT_EQ((*one)->clip.box, preset.clip.box);
    EXPECT_NEAR(keptBox(*one, volume)->high.x, -85.0, 1e-9);
    const auto moved = withFace(*one, Face::left, -88.0, volume);
    ASSERT_TRUE(moved);
    EXPECT_NEAR(keptBox(*moved, volume)->high.x, -88.0, 1e-9);
    expectRefused(withFace(*one, Face::right, -99.0, volume));
}

TEST(EditedClip, WhatIsNoNumberIsRefused) {
    const Volume volume = straight();
    const glm::dvec3 centre = volume.worldBox().centre();
    for (const double bad : {kNan, kInfinite, -kInfinite}) {
        const glm::dvec3 point{centre.x, bad, centre.z};
        for (const Face face : kFaces) {
            expectRefused(withFace(std::nullopt, face, bad, volume));
            expectRefused(withSideRemoved(std::nullopt, face, point, volume));
        }
        expectRefused(withSlabKept(std::nullopt, slices::Orientation::axial, point, 10.0, volume));
        expectRefused(withBallRemoved(std::nullopt, point, 6.0, volume));
        expectRefused(
            withCornerRemoved(std::nullopt, {Face::left, Face::anterior, Face::superior}, point, volume));
    }
}

TEST(KeptBox, OfAClipThatLeavesNothingSaysSo) {
    const Volume volume = straight();
    ClipPreset nothing;
    nothing.clip.planes.push_back({{1, 0, 0}, 0.0});
    nothing.planesAt.emplace_back(5.0, 0.5, 0.5);
    const Result<Box> kept = keptBox(nothing, volume);
    ASSERT_FALSE(kept);
    EXPECT_FALSE(kept.error().hint.empty());
    expectRefused(withFace(nothing, Face::left, -85.0, volume));
}

TEST(KeptBox, WithoutAClipIsTheVolume) {
    for (const Volume& volume : allKinds()) {
        const Result<Box> kept = keptBox(std::nullopt, volume);
        ASSERT_TRUE(kept);
        EXPECT_EQ(kept->low, volume.worldBox().low);
        EXPECT_EQ(kept->high, volume.worldBox().high);
    }
}

}  // namespace
}  // namespace macula::scene
