// Where a clip is taken hold of, in the volume and on slices, and what of a slice it removes.
#include "scene/clip/clip_handles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "base/phantom.h"
#include "scene/choice/clip_choice.h"
#include "scene/clip/edited_clip.h"
#include "scene/clip/eye_cut.h"
#include "scene/clip/removed_on_slice.h"
#include "scene/clip/scissor_cut.h"

namespace macula::scene {
namespace {

using Kind = ClipHandle::Kind;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

const Volume& volume() {
    static const Volume made = phantom::make({.size = {12, 10, 8}, .spacingMm = {20, 20, 25}});
    return made;
}

Camera oblique() {
    return {.positionMm = {500, -900, 300}, .targetMm = {0, 0, 0}, .up = {0, 0, 1}, .verticalFovDeg = 30};
}

std::vector<slices::SliceFrame> frames() {
    const slices::SlicePlane tilted{
        .centreMm = {5, -6, 7},
        .right = glm::normalize(glm::dvec3(1, 0.2, 0.1)),
        .down = glm::normalize(glm::cross(glm::dvec3(0.3, -0.4, 1), glm::dvec3(1, 0.2, 0.1)))};
    std::vector<slices::SliceFrame> all;
    for (const slices::SlicePlane& plane : {slices::planeOf(slices::Orientation::axial, {3, 4, 5}),
                                            slices::planeOf(slices::Orientation::coronal, {3, 4, 5}),
                                            slices::planeOf(slices::Orientation::sagittal, {3, 4, 5}),
                                            slices::acquiredPlane(volume(), {1, 2, 3}), tilted})
        all.push_back({.plane = plane, .mmPerPixel = 1.1, .sizePx = {260, 240}});
    return all;
}

// A kept box, an oblique plane, a corner and a ball that are removed.
ClipPreset allParts() {
    OptionalClip clip = *withFace(std::nullopt, Face::left, 70.0, volume());
    clip = *withFace(clip, Face::superior, 60.0, volume());
    clip = *withCornerRemoved(clip, {Face::right, Face::anterior, Face::inferior}, {-40, -30, -20}, volume());
    clip = *withBallRemoved(clip, {10, 5, 0}, 30.0, volume());
    ClipPreset preset = *clip;
    preset.clip.planes.push_back({.normal = glm::normalize(glm::dvec3(1, 1, 0.3)), .offsetMm = 0.0});
    preset.planesAt.push_back(glm::dvec3(0.3));
    return preset;
}

const PlacedHandle* find(const std::vector<PlacedHandle>& handles, Kind kind, Face face = Face::right) {
    const auto found = std::ranges::find_if(handles, [&](const PlacedHandle& placed) {
        const bool isFace = kind == Kind::face || kind == Kind::removedFace;
        return placed.handle.kind == kind && (!isFace || placed.handle.face == face);
    });
    return found == handles.end() ? nullptr : &*found;
}

// Whatever is painted dark is what is not shown in 3D, and nothing else.
TEST(RemovedOnSlice, IsWhatTheClipDoesNotShow) {
    std::vector<Clip> clips{
        clipFor(allParts(), {.eye = *eyeCut(oblique(), -40.0, true, volume())}, volume())};
    clips.push_back(clips[0]);
    clips[1].ofBall = Keep::inside;
    clips[1].cut.reset();
    clips.push_back({});
    clips[2].box = OrientedBox{.centreMm = {0, 0, 0}, .axes = glm::dmat3(1.0), .halfSizeMm = {30, 50, 40}};
    clips[2].ofBox = Keep::outside;
    clips.push_back({});  // nothing is clipped
    clips.push_back({});
    clips[4].ball = Ball{.centreMm = {0, 0, 900}, .radiusMm = 50};  // all of the slice is removed
    for (const Clip& clip : clips) {
        for (const slices::SliceFrame& frame : frames()) {
            const std::vector<Contour> removed = removedContours(clip, frame);
            int checked = 0;
            for (int y = 3; y < frame.sizePx.y; y += 7) {
                for (int x = 3; x < frame.sizePx.x; x += 7) {
                    const glm::dvec2 px(x + 0.37, y + 0.41);
                    const glm::dvec3 mm = frame.worldFromPicture(px);
                    // A ball is a polygon: near its border they may differ by a fraction of a millimetre.
                    if (clip.ball &&
                        std::abs(glm::distance(mm, clip.ball->centreMm) - clip.ball->radiusMm) < 1.0)
                        continue;
                    ASSERT_EQ(isInsideContours(removed, px), !shows(clip, mm)) << x << " " << y;
                    ++checked;
                }
            }
            EXPECT_GT(checked, 300);
        }
    }
}

TEST(RemovedOnSlice, OfScissorsIsWhatIsBehindTheirOutline) {
    ScissorCut cut{.camera = oblique(), .outline = {{-0.1, -0.1}, {0.15, -0.05}, {0.02, 0.0}, {0.05, 0.2}}};
    for (const bool isClose : {false, true}) {
        // The second eye is within the volume: slices go past it.
        if (isClose) cut.camera = {.positionMm = {0, -5, 10}, .targetMm = {10, 40, 0}, .verticalFovDeg = 90};
        const ScissorBlades blades(cut);
        for (const slices::SliceFrame& frame : frames()) {
            const std::vector<Contour> behind = behindOutline(cut, frame);
            for (int y = 0; y < frame.sizePx.y; y += 5) {
                for (int x = 0; x < frame.sizePx.x; x += 5) {
                    const glm::dvec2 px(x + 0.37, y + 0.41);
                    ASSERT_EQ(isInsideContours(behind, px), blades.removesPoint(frame.worldFromPicture(px)))
                        << x << " " << y;
                }
            }
        }
    }
}

// A slice through the eye, or along parallel rays, is a line in that picture, and strips of it are removed.
TEST(RemovedOnSlice, OfScissorsAreStripsWhereTheSliceIsSeenFromItsEdge) {
    ScissorCut cut{.outline = {{-0.2, -0.1},
                               {0.2, -0.1},
                               {0.2, 0.1},
                               {0.1, 0.1},
                               {0.1, -0.05},
                               {-0.1, -0.05},
                               {-0.1, 0.1},
                               {-0.2, 0.1}}};
    const std::vector<Camera> cameras{
        {.positionMm = {0, -500, 0}, .targetMm = {0, 0, 0}},
        {.positionMm = {20, -30, 0}, .targetMm = {0, 0, 0}, .verticalFovDeg = 90},  // within the slice
        {.positionMm = {300, -400, 0}, .targetMm = {0, 0, 0}, .parallelHeightMm = 300}};
    const slices::SliceFrame frame{.plane = slices::planeOf(slices::Orientation::axial, {0, 0, 0}),
                                   .mmPerPixel = 1.0,
                                   .sizePx = {200, 180}};
    for (const Camera& camera : cameras) {
        cut.camera = camera;
        const ScissorBlades blades(cut);
        const std::vector<Contour> behind = behindOutline(cut, frame);
        EXPECT_EQ(behind.size(), 2u);
        int removed = 0;
        for (int y = 0; y < frame.sizePx.y; y += 5) {
            for (int x = 0; x < frame.sizePx.x; x += 5) {
                const glm::dvec2 px(x + 0.37, y + 0.41);
                const bool isRemoved = blades.removesPoint(frame.worldFromPicture(px));
                ASSERT_EQ(isInsideContours(behind, px), isRemoved) << x << " " << y;
                removed += isRemoved;
            }
        }
        EXPECT_GT(removed, 20);
    }
    // In the plane of the eye, across its view, nothing is before it.
    cut.camera = {.positionMm = {0, 0, 0}, .targetMm = {0, 0, 100}, .up = {0, 1, 0}};
    EXPECT_TRUE(behindOutline(cut, frame).empty());
}

TEST(RemovedOnSlice, HasLinesWhereTheClipHasBorders) {
    const slices::SliceFrame axial = frames()[0];
    EXPECT_TRUE(clipLines(std::nullopt, {}, volume(), axial).empty());
    const OptionalClip left = *withFace(std::nullopt, Face::left, 70.0, volume());
    const auto lines = clipLines(left, {}, volume(), axial);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].front(), lines[0].back()) << "closed";
    EXPECT_EQ(clipLines(allParts(), {}, volume(), axial).size(), 3u) << "the corner lies lower";
    slices::SliceFrame lower = axial;
    lower.plane.centreMm.z = -25.0;
    EXPECT_EQ(clipLines(allParts(), {}, volume(), lower).size(), 4u);
    EXPECT_TRUE(
        clipLines(left, {}, volume(), {.plane = axial.plane, .mmPerPixel = 0.0, .sizePx = {9, 9}}).empty());
    EXPECT_TRUE(removedContours(clipFor(left, {}, volume()),
                                {.plane = axial.plane, .mmPerPixel = kNan, .sizePx = {9, 9}})
                    .empty());
}

TEST(ClipHandles, WithoutAClipAreAtTheFacesOfTheVolume) {
    const auto handles = handlesOf(std::nullopt, {}, volume());
    ASSERT_EQ(handles.size(), 6u);
    const Box all = volume().worldBox();
    for (const Face face : kFaces) {
        const PlacedHandle* placed = find(handles, Kind::face, face);
        ASSERT_NE(placed, nullptr);
        EXPECT_EQ(placed->atMm[axisOf(face)], faceMm(all, face));
        EXPECT_EQ(placed->along[axisOf(face)], isHigh(face) ? 1.0 : -1.0);
    }
    const auto moved =
        withHandleAt(std::nullopt, {}, {.kind = Kind::face, .face = Face::left}, {40, 999, 999}, volume());
    ASSERT_TRUE(moved.ok());
    EXPECT_NEAR(keptBox(moved->clip, volume())->high.x, 40.0, 1e-9);
}

// Where a handle was dragged to, it is then.
TEST(ClipHandles, ThePartGoesThroughThePointThatItsHandleIsDraggedTo) {
    const ClipPreset clip = allParts();
    const Cuts cuts{.eye = *eyeCut(oblique(), -40.0, true, volume()), .scissors = {}};
    const auto handles = handlesOf(clip, cuts, volume());
    EXPECT_EQ(handles.size(), 6u + 1u + 1u + 2u + 1u);
    for (const PlacedHandle& placed : handles) {
        const glm::dvec3 by = placed.along == glm::dvec3(0.0) ? glm::dvec3(5, -6, 4) : -7.0 * placed.along;
        const auto moved = withHandleAt(clip, cuts, placed.handle, placed.atMm + by, volume());
        ASSERT_TRUE(moved.ok()) << int(placed.handle.kind);
        const auto after = handlesOf(moved->clip, moved->cuts, volume());
        const auto same = std::ranges::find(after, placed.handle, &PlacedHandle::handle);
        ASSERT_NE(same, after.end());
        const glm::dvec3 off = same->atMm - (placed.atMm + by);
        const double offMm = placed.along == glm::dvec3(0.0) ? glm::length(off) : glm::dot(off, placed.along);
        EXPECT_NEAR(offMm, 0.0, 1e-6) << int(placed.handle.kind);
        EXPECT_TRUE(validate(clipFor(moved->clip, moved->cuts, volume())).ok());
    }
}

TEST(ClipHandles, ARemovedBoxHasFacesOfItsOwn) {
    OptionalClip clip = *withFace(std::nullopt, Face::left, 70.0, volume());
    clip = *withFace(clip, Face::right, -50.0, volume());
    clip = *turnedInsideOut(clip, volume());
    const auto handles = handlesOf(clip, {}, volume());
    const PlacedHandle* left = find(handles, Kind::removedFace, Face::left);
    ASSERT_NE(left, nullptr);
    EXPECT_NEAR(left->atMm.x, 70.0, 1e-9);
    const auto moved = withHandleAt(clip, {}, left->handle, {30, 0, 0}, volume());
    ASSERT_TRUE(moved.ok());
    const Clip inMm = clipFor(moved->clip, {}, volume());
    EXPECT_TRUE(shows(inMm, {31, 0, 0}));
    EXPECT_FALSE(shows(inMm, {29, 0, 0}));
    EXPECT_FALSE(shows(inMm, {-49, 0, 0}));
    // It never passes the face across from it.
    const auto squeezed = withHandleAt(clip, {}, left->handle, {-90, 0, 0}, volume());
    ASSERT_TRUE(squeezed.ok());
    EXPECT_TRUE(validate(clipFor(squeezed->clip, {}, volume())).ok());
}

TEST(ClipHandles, OnASliceLieOnTheBordersAndMoveThem) {
    const ClipPreset clip = allParts();
    const Cuts cuts{.eye = *eyeCut(oblique(), -40.0, true, volume()), .scissors = {}};
    std::vector<slices::SliceFrame> all = frames();
    all.push_back(all[0]);
    all.back().plane.centreMm.z = -40.0;  // through the corner
    EXPECT_NE(find(handlesOn(all.back(), clip, cuts, volume()), Kind::corner), nullptr);
    for (const slices::SliceFrame& frame : all) {
        const auto handles = handlesOn(frame, clip, cuts, volume());
        EXPECT_GE(handles.size(), 3u);
        for (const PlacedHandle& placed : handles) {
            EXPECT_NEAR(frame.distanceMm(placed.atMm), 0.0, 1e-6);
            EXPECT_NEAR(glm::dot(placed.along, frame.plane.normal()), 0.0, 1e-9);
            const glm::dvec2 px = frame.pictureFromWorld(placed.atMm);
            EXPECT_TRUE(px.x >= 0 && px.y >= 0 && px.x <= frame.sizePx.x && px.y <= frame.sizePx.y);
            const bool isPoint = placed.along == glm::dvec3(0.0);
            const glm::dvec3 onSlice =
                placed.atMm + (isPoint ? 4.0 * frame.plane.right : -4.0 * placed.along);
            const auto moved =
                withHandleAt(clip, cuts, placed.handle,
                             draggedTo(placed.handle, onSlice, frame, clip, volume()), volume());
            ASSERT_TRUE(moved.ok()) << int(placed.handle.kind);
            const auto after = handlesOn(frame, moved->clip, moved->cuts, volume());
            const auto same = std::ranges::find(after, placed.handle, &PlacedHandle::handle);
            ASSERT_NE(same, after.end()) << int(placed.handle.kind);
            const glm::dvec3 off = same->atMm - onSlice;
            EXPECT_NEAR(isPoint ? glm::length(off) : glm::dot(off, placed.along), 0.0, 1e-6)
                << int(placed.handle.kind);
        }
    }
}

// On an axial slice, faces above and below are no lines, though the slice may lie on one of them.
TEST(ClipHandles, OnASliceThatLiesOnAFaceHaveNoHandleOfIt) {
    const OptionalClip clip = *withFace(std::nullopt, Face::superior, 20.0, volume());
    const slices::SliceFrame frame{.plane = slices::planeOf(slices::Orientation::axial, {0, 0, 20.0 - 1e-6}),
                                   .mmPerPixel = 1.5,
                                   .sizePx = {300, 300}};
    const auto handles = handlesOn(frame, clip, {}, volume());
    EXPECT_EQ(handles.size(), 4u);
    EXPECT_EQ(find(handles, Kind::face, Face::superior), nullptr);
    slices::SliceFrame above = frame;
    above.plane.centreMm.z = 25.0;
    EXPECT_TRUE(handlesOn(above, clip, {}, volume()).empty()) << "nothing is kept there";
}

TEST(ClipHandles, SayWhatIsWrong) {
    const auto fails = [](const OptionalClip& clip, const ClipHandle& handle, const glm::dvec3& mm) {
        const auto moved = withHandleAt(clip, {}, handle, mm, volume());
        return !moved.ok() && moved.error().code == ErrorCode::usage && !moved.error().hint.empty();
    };
    for (const Kind kind :
         {Kind::removedFace, Kind::plane, Kind::eye, Kind::corner, Kind::ballCentre, Kind::ballRadius})
        EXPECT_TRUE(fails(std::nullopt, {.kind = kind}, {0, 0, 0})) << int(kind);
    EXPECT_TRUE(fails(std::nullopt, {.kind = Kind::face}, glm::dvec3(kNan)));
    const ClipPreset clip = allParts();
    for (const PlacedHandle& placed : handlesOf(clip, {}, volume()))
        EXPECT_TRUE(fails(clip, placed.handle, glm::dvec3(kNan))) << int(placed.handle.kind);
    EXPECT_TRUE(fails(clip, {.kind = Kind::plane, .plane = 99}, {0, 0, 0}));
    EXPECT_TRUE(handlesOn({.plane = {}, .mmPerPixel = kNan, .sizePx = {10, 10}}, clip, {}, volume()).empty());
    EXPECT_TRUE(handlesOn({.plane = {}, .mmPerPixel = 1.0, .sizePx = {0, 0}}, clip, {}, volume()).empty());
}

}  // namespace
}  // namespace macula::scene
