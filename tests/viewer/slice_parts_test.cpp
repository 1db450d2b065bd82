// What a pane of slices is made of, without a widget.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "viewer/language/harmless_text.h"
#include "viewer/overlay/cube_and_scale.h"
#include "viewer/overlay/measurement_handles.h"
#include "viewer/overlay/slice_steps.h"
#include "viewer/overlay/slice_texts.h"
#include "viewer/slice_volume.h"
#include "viewer/slices/clip_on_slice.h"
#include "viewer/slices/pane_content.h"
#include "viewer/slices/pane_measurements.h"

namespace macula::viewer {
namespace {

using slices::Orientation;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(ScaleBar, IsARoundNumberAndAsLongAsItMayBe) {
    for (double mmPerPx = 1e-3; mmPerPx < 1e3; mmPerPx *= 1.37) {
        const auto bar = scaleBar(mmPerPx, 120.0, true);
        ASSERT_TRUE(bar) << mmPerPx;
        const double power = std::pow(10.0, std::floor(std::log10(bar->lengthMm) + 1e-6));
        const double digit = bar->lengthMm / power;
        EXPECT_TRUE(std::abs(digit - 1) < 1e-6 || std::abs(digit - 2) < 1e-6 || std::abs(digit - 5) < 1e-6)
            << bar->lengthMm;
        EXPECT_NEAR(bar->lengthPx * mmPerPx, bar->lengthMm, 1e-9 * bar->lengthMm);
        EXPECT_LE(bar->lengthPx, 120.0001);
        EXPECT_GT(bar->lengthPx, 120.0 / 2.5 - 1e-6);
    }
}

TEST(ScaleBar, IsInCentimetresFromOneOn) {
    EXPECT_EQ(scaleBar(0.5, 120.0, true)->text, "5 cm");
    EXPECT_EQ(scaleBar(1.0, 100.0, true)->text, "10 cm");
    EXPECT_EQ(scaleBar(0.05, 120.0, true)->text, "5 mm");
    EXPECT_EQ(scaleBar(0.005, 100.0, true)->text, "0.5 mm");
    for (const double bad : {0.0, -1.0, kNaN, std::numeric_limits<double>::infinity()})
        EXPECT_FALSE(scaleBar(bad, 120.0, true));
    EXPECT_FALSE(scaleBar(1.0, 0.0, true));
}

TEST(ScaleBar, SaysThatItIsAnEstimate) {
    const auto bar = scaleBar(0.5, 120.0, false);
    ASSERT_TRUE(bar);
    EXPECT_EQ(bar->text, QStringLiteral("≈ 5 cm"));
    EXPECT_FALSE(bar->isCalibrated);
    EXPECT_DOUBLE_EQ(bar->lengthMm, 50.0);
    EXPECT_EQ(notCalibrated(bar->text), QStringLiteral("≈ 5 cm, not calibrated"));
    EXPECT_EQ(sizeText(QStringLiteral("310 mm²"), false), QStringLiteral("≈ 310 mm², not calibrated"));
    EXPECT_EQ(sizeText(QStringLiteral("310 mm²"), true), QStringLiteral("310 mm²"));
}

TEST(MeasurementTexts, SayThatSizesAreNotCalibratedAndLeaveAnglesAlone) {
    VolumeOptions options = test::sliceVolumeOptions();
    options.provenance.isCalibrated = false;
    const auto volume = test::sliceVolume(std::move(options));
    MeasurementTexts texts;
    const slices::Distance distance{{glm::dvec3(0.0), glm::dvec3(3.0, 4.0, 0.0)}};
    EXPECT_EQ(texts.of({.shape = distance}, volume), QStringLiteral("≈ 5.0 mm, not calibrated"));
    EXPECT_EQ(texts.of({.label = "cyst", .shape = distance}, volume),
              QStringLiteral("cyst: ≈ 5.0 mm, not calibrated"));
    const slices::Angle angle{{glm::dvec3(1, 0, 0), glm::dvec3(0.0), glm::dvec3(0, 1, 0)}};
    EXPECT_EQ(texts.of({.shape = angle}, volume), QStringLiteral("90.0°"));
    slices::Ellipse ellipse{.radiiMm = {2.0, 2.0}};
    EXPECT_EQ(texts.of({.shape = ellipse}, volume),
              QStringLiteral("0 ± 0 HU, min 0, max 0, ≈ 12.6 mm², not calibrated"));
    texts.forget();
    EXPECT_EQ(texts.of({.shape = distance}, test::sliceVolume()), QStringLiteral("5.0 mm"));
}

TEST(MeasurementTexts, SayHowMuchOfThemIsInterpolated) {
    VolumeOptions options = test::sliceVolumeOptions();
    options.provenance.interpolatedSlices = {{.first = 10, .last = 12}};
    const auto volume = test::sliceVolume(std::move(options));
    MeasurementTexts texts;
    // A column of one voxel through slices 7 to 13: three of seven.
    const slices::Ellipse column{.plane = slices::planeOf(Orientation::coronal, {0.0, 0.0, 0.0}),
                                 .radiiMm = {0.4, 6.9}};
    EXPECT_TRUE(texts.of({.shape = column}, volume).endsWith(", 43 % interpolated"))
        << texts.of({.shape = column}, volume).toStdString();
    const slices::Distance up{{glm::dvec3(0.0, 0.0, -10.0), {0.0, 0.0, 2.0}}};
    EXPECT_EQ(texts.of({.shape = up}, volume), "12.0 mm, ends in interpolated slices");
    const slices::Distance below{{glm::dvec3(0.0, 0.0, -10.0), {0.0, 0.0, -4.0}}};
    EXPECT_EQ(texts.of({.shape = below}, volume), "6.0 mm");
}

TEST(SliceSteps, GoThroughTheVoxelsOfAStraightVolume) {
    const auto volume = test::sliceVolume();
    const SliceSteps axial(*volume, Orientation::axial, false);
    EXPECT_EQ(axial.count(), 21);
    EXPECT_TRUE(axial.areAcquired());
    EXPECT_DOUBLE_EQ(axial.stepMm(), 2.0);
    EXPECT_DOUBLE_EQ(axial.onSlice(0, {5.0, 6.0, 7.0}).z, -20.0);
    EXPECT_DOUBLE_EQ(axial.onSlice(0, {5.0, 6.0, 7.0}).x, 5.0);
    EXPECT_EQ(axial.nearest({0.0, 0.0, 3.1}), 12);
    EXPECT_EQ(axial.nearest({0.0, 0.0, 1e12}), 20);
    EXPECT_EQ(axial.nearest({0.0, 0.0, -1e300}), 0);
    EXPECT_EQ(axial.nearest({0.0, 0.0, kNaN}), 10);
    // Away from who looks is the patient's right: voxels are counted against it.
    const SliceSteps sagittal(*volume, Orientation::sagittal, false);
    EXPECT_EQ(sagittal.count(), 41);
    EXPECT_DOUBLE_EQ(sagittal.stepMm(), -1.0);
    EXPECT_EQ(sagittal.nearest({-20.0, 0.0, 0.0}), 0);
    EXPECT_FALSE(sagittal.areAcquired());
    for (const Orientation orientation : {Orientation::axial, Orientation::coronal, Orientation::sagittal}) {
        const SliceSteps steps(*volume, orientation, false);
        EXPECT_NEAR(std::abs(steps.stepMm()), slices::stepMm(*volume, steps.plane(0, {})), 1e-9);
    }
}

TEST(SliceSteps, OfAnObliqueVolumeAreThePatientsOrTheScanners) {
    const double turn = 0.3;
    VolumeOptions options = test::sliceVolumeOptions();
    options.worldFromVoxel = affine({std::cos(turn), std::sin(turn), 0.0},
                                    {-std::sin(turn), std::cos(turn), 0.0}, {0.0, 0.0, 2.0}, {3.0, 4.0, 5.0});
    const auto volume = test::sliceVolume(options);
    const SliceSteps straight(*volume, Orientation::coronal, false);
    EXPECT_TRUE(straight.areStraight());
    EXPECT_DOUBLE_EQ(straight.stepMm(), 1.0);
    EXPECT_GT(straight.count(), 31) << "its corners stick out";
    std::array<SliceSteps, 3> panes{SliceSteps(*volume, Orientation::axial, true),
                                    SliceSteps(*volume, Orientation::coronal, true),
                                    SliceSteps(*volume, Orientation::sagittal, true)};
    EXPECT_TRUE(panes[0].areAcquired());
    EXPECT_EQ(panes[1].count(), 31);
    EXPECT_EQ(panes[2].count(), 41);
    EXPECT_FALSE(panes[1].areStraight());
    for (int a = 0; a < 3; ++a) {
        const glm::dvec3 one = panes[std::size_t(a)].plane(0, {}).normal();
        const glm::dvec3 other = panes[std::size_t((a + 1) % 3)].plane(0, {}).normal();
        EXPECT_NEAR(glm::dot(one, other), 0.0, 1e-9);
        EXPECT_GT(glm::dot(one, slices::planeOf(Orientation(a), {}).normal()), 0.9) << "never mirrored";
    }
}

TEST(SliceSteps, OfATiltedGantryAreAsFarApartAsItsPlanes) {
    VolumeOptions options = test::sliceVolumeOptions();
    options.worldFromVoxel = affine({1, 0, 0}, {0, 1, 0}, {0, 0.7, 2}, {-20, -22, -20});
    const auto volume = test::sliceVolume(options);
    const SliceSteps axial(*volume, Orientation::axial, false);
    EXPECT_EQ(axial.count(), 21);
    EXPECT_NEAR(axial.stepMm(), 2.0, 1e-12);
    EXPECT_NEAR(axial.onSlice(20, {}).z, 20.0, 1e-9);
}

// Perpendicular as before, and one plane of each pane contains the point that a person turned them about.
TEST(SliceSteps, ThatAPersonTurnedMeetThePointThatTheyTurnAbout) {
    const auto volume = test::sliceVolume();
    const PlaneTurn turn{.turn = glm::angleAxis(0.5, glm::normalize(glm::dvec3(1.0, 2.0, -0.5))),
                         .aboutMm = {3.3, -4.7, 1.9}};
    std::vector<glm::dvec3> normals;
    for (const Orientation orientation : {Orientation::axial, Orientation::coronal, Orientation::sagittal}) {
        const SliceSteps steps(*volume, orientation, false, turn);
        const slices::SlicePlane plane = steps.plane(steps.nearest(turn.aboutMm), turn.aboutMm);
        EXPECT_LT(glm::distance(plane.centreMm, turn.aboutMm), 1e-9);
        EXPECT_FALSE(steps.areStraight());
        EXPECT_FALSE(steps.areAcquired());
        EXPECT_GT(steps.turnedDeg(), 1.0);
        EXPECT_LT(steps.turnedDeg(), glm::degrees(0.5) + 1e-9);
        const glm::dvec3 next = steps.onSlice(steps.nearest(turn.aboutMm) + 1, turn.aboutMm);
        EXPECT_NEAR(glm::distance(next, turn.aboutMm), std::abs(steps.stepMm()), 1e-9);
        normals.push_back(plane.normal());
    }
    for (int a = 0; a < 3; ++a) EXPECT_NEAR(glm::dot(normals[a], normals[(a + 1) % 3]), 0.0, 1e-12);
    // A turn by nothing is no turn: the slices are those of the voxels.
    const SliceSteps none(*volume, Orientation::axial, false, PlaneTurn{.aboutMm = {0.0, 0.0, 0.7}});
    EXPECT_EQ(none.count(), 21);
    EXPECT_TRUE(none.areAcquired());
    EXPECT_EQ(none.turnedDeg(), 0.0);
}

TEST(PaneView, WhatIsUnderThePointerStaysThereAndFollowsTheHand) {
    const auto volume = test::sliceVolume();
    const SliceSteps steps(*volume, Orientation::coronal, false);
    const glm::ivec2 size(300, 200);
    const PaneView fitted = fittedView(*volume, steps, size);
    const auto worldAt = [&](const PaneView& view, const glm::dvec2& px) {
        return frameOf(view, steps, 15, size, 2.0).worldFromPicture(2.0 * px);
    };
    const glm::dvec2 fromMiddle(70.0, -40.0);
    const glm::dvec2 place = glm::dvec2(150.0, 100.0) + fromMiddle;
    const PaneView closer = zoomed(fitted, steps.plane(15, {}), fromMiddle, 3.0, fitted.mmPerPx);
    EXPECT_NEAR(closer.mmPerPx, fitted.mmPerPx / 3.0, 1e-12);
    EXPECT_LT(glm::distance(worldAt(fitted, place), worldAt(closer, place)), 1e-9);
    const PaneView moved = panned(closer, steps.plane(15, {}), {12.0, 5.0});
    EXPECT_LT(glm::distance(worldAt(moved, place + glm::dvec2(12.0, 5.0)), worldAt(closer, place)), 1e-9);
    EXPECT_DOUBLE_EQ(zoomed(fitted, steps.plane(15, {}), {}, 1e9, fitted.mmPerPx).mmPerPx,
                     fitted.mmPerPx / 64.0);
    EXPECT_DOUBLE_EQ(zoomed(fitted, steps.plane(15, {}), {}, 1e-9, fitted.mmPerPx).mmPerPx,
                     fitted.mmPerPx * 4.0);
    EXPECT_EQ(zoomed(fitted, steps.plane(15, {}), {}, kNaN, fitted.mmPerPx), fitted);
    EXPECT_EQ(frameOf(fitted, steps, 15, size, 2.0).sizePx, glm::ivec2(600, 400));
    EXPECT_GT(fittedView(*volume, steps, glm::ivec2(0)).mmPerPx, 0.0);
}

slices::SlicePlane axialAt(double z) {
    return slices::planeOf(Orientation::axial, {0.0, 0.0, z});
}

TEST(MeasurementDrawing, IsDoneAfterADragOrTwoClicks) {
    MeasurementDrawing dragged(SliceTool::distance, axialAt(4.0), {0.0, 0.0, 4.0}, 0.1);
    EXPECT_FALSE(dragged.soFar()) << "a point has no length";
    dragged.move({3.0, 0.0, 4.0});
    EXPECT_NEAR(slices::lengthMm(std::get<slices::Distance>(dragged.soFar()->shape)), 3.0, 1e-12);
    dragged.release({3.0, 4.0, 4.0});
    ASSERT_TRUE(dragged.isComplete());
    EXPECT_NEAR(slices::lengthMm(std::get<slices::Distance>(dragged.soFar()->shape)), 5.0, 1e-12);
    EXPECT_EQ(dragged.soFar()->normal, axialAt(4.0).normal());

    MeasurementDrawing clicked(SliceTool::distance, axialAt(4.0), {0.0, 0.0, 4.0}, 0.1);
    clicked.release({0.05, 0.0, 4.0});  // the hand shook
    EXPECT_FALSE(clicked.isComplete());
    clicked.press({0.05, 0.0, 4.0});  // twice at one place
    EXPECT_FALSE(clicked.isComplete());
    clicked.press({0.0, 7.0, 4.0});
    EXPECT_TRUE(clicked.isComplete());
    clicked.move({9.0, 9.0, 4.0});
    EXPECT_NEAR(slices::lengthMm(std::get<slices::Distance>(clicked.soFar()->shape)), 7.0, 1e-12);
}

TEST(MeasurementDrawing, OfAnAngleHasItsVertexSecond) {
    MeasurementDrawing angle(SliceTool::angle, axialAt(0.0), {5.0, 0.0, 0.0}, 0.1);
    angle.move({1.0, 0.0, 0.0});
    EXPECT_TRUE(std::holds_alternative<slices::Distance>(angle.soFar()->shape)) << "its first leg";
    angle.press({0.0, 0.0, 0.0});
    angle.release({0.0, 0.0, 0.0});
    EXPECT_FALSE(angle.isComplete());
    angle.move({3.0, 3.0, 0.0});
    EXPECT_NEAR(slices::angleDeg(std::get<slices::Angle>(angle.soFar()->shape)), 45.0, 1e-9);
    angle.press({0.0, 3.0, 0.0});
    ASSERT_TRUE(angle.isComplete());
    EXPECT_NEAR(slices::angleDeg(std::get<slices::Angle>(angle.soFar()->shape)), 90.0, 1e-9);
}

TEST(MeasurementDrawing, AnEllipseLiesInItsRectangle) {
    MeasurementDrawing drawing(SliceTool::ellipse, axialAt(0.0), {8.0, 1.0, 0.0}, 0.1);
    drawing.move({2.0, 1.0, 0.0});
    EXPECT_FALSE(drawing.soFar()) << "no height yet";
    drawing.release({2.0, 5.0, 0.0});
    const std::optional<slices::Measurement> measurement = drawing.soFar();
    const auto& ellipse = std::get<slices::Ellipse>(measurement->shape);
    EXPECT_LT(glm::distance(ellipse.plane.centreMm, glm::dvec3(5.0, 3.0, 0.0)), 1e-12);
    EXPECT_LT(glm::distance(ellipse.radiiMm, glm::dvec2(3.0, 2.0)), 1e-12);
}

slices::Measurement distanceBetween(const glm::dvec3& a, const glm::dvec3& b) {
    return {.shape = slices::Distance{.endsMm = {a, b}}, .normal = axialAt(0.0).normal()};
}

TEST(MeasurementHandles, AMovedOneStaysInItsPlaneAndKeepsAnExtent) {
    const slices::Measurement distance = distanceBetween({0.0, 0.0, 0.0}, {5.0, 0.0, 0.0});
    const slices::Measurement longer = withHandleAt(distance, 1, {9.0, 1.0, 0.4});
    EXPECT_LT(glm::distance(handlesOf(longer)[1], glm::dvec3(9.0, 1.0, 0.0)), 1e-12);
    EXPECT_EQ(handlesOf(longer)[0], handlesOf(distance)[0]);
    EXPECT_EQ(withHandleAt(distance, 1, {0.0, 0.0, 0.0}), distance);

    slices::Measurement ellipse{.shape = slices::Ellipse{.plane = axialAt(0.0), .radiiMm = {3.0, 2.0}},
                                .normal = axialAt(0.0).normal()};
    ASSERT_EQ(handlesOf(ellipse).size(), 5u);
    const auto& wider = withHandleAt(ellipse, 1, {-7.0, 1.0, 0.0});
    EXPECT_EQ(std::get<slices::Ellipse>(wider.shape).radiiMm, glm::dvec2(7.0, 2.0));
    const auto& shifted = withHandleAt(ellipse, 4, {1.0, 2.0, 0.0});
    EXPECT_EQ(std::get<slices::Ellipse>(shifted.shape).plane.centreMm, glm::dvec3(1.0, 2.0, 0.0));
    EXPECT_EQ(std::get<slices::Ellipse>(shifted.shape).radiiMm, glm::dvec2(3.0, 2.0));
    EXPECT_EQ(withHandleAt(ellipse, 0, {0.0, 5.0, 0.0}), ellipse) << "no width would be left";
}

TEST(MeasurementHandles, TheNearestOneIsHitBeforeAnyLine) {
    const slices::SliceFrame frame{.plane = axialAt(0.0), .mmPerPixel = 0.5, .sizePx = {200, 200}};
    const std::array measurements{distanceBetween({-20.0, 0.0, 0.0}, {20.0, 0.0, 0.0}),
                                  distanceBetween({0.0, 2.0, 0.0}, {0.0, 30.0, 0.0})};
    const std::vector<bool> all(2, true);
    const auto at = [&](double x, double y, const std::vector<bool>& shown) {
        return hitAt(measurements, shown, frame, frame.pictureFromWorld({x, y, 0.0}), 8.0);
    };
    EXPECT_EQ(at(0.0, 1.0, all), (Hit{.measurement = 1, .handle = 0}));
    EXPECT_EQ(at(-19.0, 1.0, all), (Hit{.measurement = 0, .handle = 0}));
    EXPECT_EQ(at(10.0, -3.0, all), (Hit{.measurement = 0}));
    EXPECT_EQ(at(10.0, -5.0, all), std::nullopt);
    EXPECT_EQ(at(10.0, -3.0, {false, true}), std::nullopt) << "it is not seen";
}

TEST(SliceTexts, SidesOfThePictureAreThoseOfThePatient) {
    const auto letters = [](Orientation orientation) {
        const scene::EdgeLetters sides = edgeLetters(slices::planeOf(orientation, {}));
        return sides.left + sides.right + sides.top + sides.bottom;
    };
    EXPECT_EQ(letters(Orientation::axial), "RLAP");
    EXPECT_EQ(letters(Orientation::coronal), "RLSI");
    EXPECT_EQ(letters(Orientation::sagittal), "APSI");
    const scene::EdgeLetters oblique = edgeLetters({.right = glm::normalize(glm::dvec3(1.0, 0.3, 0.0)),
                                                    .down = glm::normalize(glm::dvec3(-0.3, 1.0, 0.0))});
    EXPECT_EQ(oblique.left, "RA");
    EXPECT_EQ(oblique.bottom, "PR");
}

TEST(SliceTexts, SayWhereAndWhat) {
    VolumeOptions options = test::sliceVolumeOptions();
    options.padding = StoredRange{.low = 2000, .high = 2000};
    const auto volume = test::sliceVolume(options);
    const auto position = [&](Orientation orientation, int slice) {
        return positionText(orientation, SliceSteps(*volume, orientation, false), slice).toStdString();
    };
    EXPECT_EQ(position(Orientation::axial, 20), "Axial S 20.0 mm, slice 21 of 21");
    EXPECT_EQ(position(Orientation::coronal, 0), "Coronal A 15.0 mm");
    EXPECT_EQ(positionText(Orientation::axial, SliceSteps(*volume, Orientation::axial, false), 20, 1),
              "Axial S 20.0 mm, slice 21 of 21, image 1");
    EXPECT_EQ(position(Orientation::sagittal, 0), "Sagittal R 20.0 mm");
    EXPECT_EQ(probeText(*volume, {5.0, 4.0, 0.0}), "0 HU at (25, 19, 10), L 5.0 P 4.0 S 0.0 mm");
    EXPECT_EQ(probeText(*volume, test::kBlockCentreMm), "Padding at (7, 6, 16), R 13.0 A 9.0 S 12.0 mm");
    EXPECT_EQ(probeText(*volume, {500.0, 0.0, 0.0}), "Outside, L 500.0 P 0.0 S 0.0 mm");
    EXPECT_EQ(slabText({.thicknessMm = 10.0, .projection = slices::Projection::maximum}), "MIP 10 mm");
    EXPECT_EQ(slabText({.thicknessMm = 2.5, .projection = slices::Projection::minimum}), "MinIP 2.5 mm");
    EXPECT_EQ(slabText({}), "");
}

// The lines in a pane mark the other two, each in its own colour.
TEST(SliceTexts, LinesHaveTheColoursOfTheOtherPanes) {
    for (const Orientation orientation : {Orientation::axial, Orientation::coronal, Orientation::sagittal}) {
        const slices::SlicePlane plane = slices::planeOf(orientation, {});
        const glm::dvec3 vertical = slices::planeOf(verticalOf(orientation), {}).normal();
        const glm::dvec3 horizontal = slices::planeOf(horizontalOf(orientation), {}).normal();
        EXPECT_NEAR(std::abs(glm::dot(plane.right, vertical)), 1.0, 1e-12);
        EXPECT_NEAR(std::abs(glm::dot(plane.down, horizontal)), 1.0, 1e-12);
    }
    EXPECT_NE(colourOf(Orientation::axial), colourOf(Orientation::coronal));
    EXPECT_NE(colourOf(Orientation::coronal), colourOf(Orientation::sagittal));
}

// A pane is painted anew at each step of the pointer.
TEST(ClipDimming, IsPaintedOnceForAsLongAsNothingChanges) {
    ClipOnSlice clip;
    ClipDimming dimming;
    EXPECT_TRUE(dimming.imageFor(clip, {100, 80}, 2.0).isNull());
    // In device pixels: the left half stays.
    clip.scissors = {
        {.behind = {{{0.0, 0.0}, {100.0, 0.0}, {100.0, 160.0}, {0.0, 160.0}}}, .removesOutside = true}};
    const QImage image = dimming.imageFor(clip, {100, 80}, 2.0);
    EXPECT_EQ(image.size(), QSize(200, 160));
    EXPECT_EQ(qAlpha(image.pixel(50, 80)), 0);
    EXPECT_GT(qAlpha(image.pixel(150, 80)), 100);
    clip.held = scene::ClipHandle{};
    EXPECT_EQ(dimming.imageFor(clip, {100, 80}, 2.0).cacheKey(), image.cacheKey()) << "it was painted anew";
    EXPECT_EQ(dimming.imageFor(clip, {50, 80}, 2.0).size(), QSize(100, 160));
    clip.scissors[0].removesOutside = false;
    const QImage inside = dimming.imageFor(clip, {100, 80}, 2.0);
    EXPECT_GT(qAlpha(inside.pixel(50, 80)), 100);
    EXPECT_EQ(qAlpha(inside.pixel(150, 80)), 0);
    clip.scissors.clear();
    EXPECT_TRUE(dimming.imageFor(clip, {100, 80}, 2.0).isNull());
}

TEST(HarmlessText, LeavesNothingThatTurnsWhatFollows) {
    EXPECT_EQ(harmless(QStringLiteral("DOE\u202e, JO\u2066HN\n 2")), QStringLiteral("DOE, JOHN 2"));
}

}  // namespace
}  // namespace macula::viewer
