// Handles, scissors, cuts from the eye and clips under a name, with hands on them, against a session.
#include "live/frame/frame_input.h"  // before Qt, see viewer/viewport/vulkan_window.h

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QElapsedTimer>
#include <QTest>
#include <QThread>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>

#include "base/phantom.h"
#include "pipeline/volume/mask_bits.h"
#include "scene/choice/catalogue.h"
#include "scene/clip/edited_clip.h"
#include "scene/clip/eye_cut.h"
#include "scene/clip/scissor_mask.h"
#include "viewer/clip/clip_editing.h"
#include "viewer/clip/clip_handles_tool.h"
#include "viewer/clip/cut_tools.h"
#include "viewer/clip/named_clips.h"
#include "viewer/clip/scissor_tool.h"
#include "viewer/clip/voxel_cutting.h"
#include "viewer/volume/hidden_voxels.h"
#include "viewer/volume/shown_volume.h"
#include "viewer/wait_until.h"

namespace macula::viewer {
namespace {

using Kind = scene::ClipHandle::Kind;

class ClipToolsTest : public testing::Test {
  protected:
    void SetUp() override {
        qputenv("QT_QPA_PLATFORM", "offscreen");
        application_.emplace(argc_, argv_);
        session_.emplace(scene::Catalogue{});
        editing_.emplace(*session_);
    }

    void openPhantom() {
        session_->show({.volume = std::make_shared<const Volume>(
                            phantom::make({.size = {24, 20, 16}, .spacingMm = {12, 12, 18}}))},
                       {});
        editing_->setCamera(fromAnterior().camera);
    }
    // From the front, far away: the patient's left is at the right.
    static PictureGeometry fromAnterior() {
        return {.camera = {.positionMm = {0, -3000, 0},
                           .targetMm = {0, 0, 0},
                           .up = {0, 0, 1},
                           .verticalFovDeg = 10},
                .aspect = 1.25,
                .sizePx = {1000, 800}};
    }
    static PicturePlace placeOf(const glm::dvec3& mm, PictureGeometry picture = fromAnterior()) {
        const auto rays = scene::PictureRays::of(picture.camera, picture.aspect);
        return {.picture = picture, .at = *rays->placeOf(mm)};
    }
    static PicturePlace at(double x, double y) { return {.picture = fromAnterior(), .at = {x, y}}; }

    const Volume& volume() const { return *session_->study().volume; }
    Box all() const { return volume().worldBox(); }
    const scene::StudyState& state() const { return session_->state(); }
    Box kept() const { return *scene::keptBox(state().clip, volume()); }

    int argc_ = 1;
    char name_[5] = "test";
    char* argv_[2] = {name_, nullptr};
    std::optional<QApplication> application_;
    std::optional<StudyEditor> session_;
    std::optional<ClipEditing> editing_;
};

// The handle of the face to the patient's left, as seen from the front.
TEST_F(ClipToolsTest, AFaceIsDraggedInThePictureInOneStep) {
    openPhantom();
    ClipHandlesTool tool(*session_, *editing_);
    glm::dvec3 left = all().centre();
    left.x = all().high.x;
    EXPECT_FALSE(tool.press(placeOf(left))) << "nobody asked for handles";
    EXPECT_TRUE(tool.marks(fromAnterior()).empty());
    editing_->setHandlesAskedFor(true);
    EXPECT_EQ(tool.point(placeOf(left)), Qt::SizeHorCursor);
    EXPECT_EQ(tool.point(at(0.99, 0.99)), std::nullopt);
    EXPECT_FALSE(tool.press(at(0.99, 0.99)));
    EXPECT_GT(tool.marks(fromAnterior()).size(), 50u);

    ASSERT_TRUE(tool.press(placeOf(left)));
    glm::dvec3 to = left;
    for (const double x : {100.0, 60.0, 40.0}) {
        to.x = x;
        tool.move(placeOf(to));
    }
    tool.release(placeOf(to));
    EXPECT_NEAR(kept().high.x, 40.0, 0.5) << "L is positive, at the right of the picture";
    EXPECT_EQ(kept().low.x, all().low.x);
    EXPECT_EQ(session_->undoText(), QLatin1String("Clip"));
    session_->undo();
    EXPECT_FALSE(session_->canUndo());
    EXPECT_FALSE(state().clip);
}

// Who looks along a line cannot drag along it.
TEST_F(ClipToolsTest, FacesTowardsTheEyeHaveNoHandle) {
    openPhantom();
    editing_->setPanelOpen(true);
    ClipHandlesTool tool(*session_, *editing_);
    int handles = 0;
    for (const ToolMark& mark : tool.marks(fromAnterior())) handles += mark.kind == MarkKind::handle;
    EXPECT_EQ(handles, 4);
    editing_->setPanelOpen(false);
    EXPECT_TRUE(tool.marks(fromAnterior()).empty());
}

TEST_F(ClipToolsTest, TheBallIsMovedAcrossTheLineOfSightAndSized) {
    openPhantom();
    editing_->setHandlesAskedFor(true);
    session_->change("Clip", [&](scene::StudyState& next) {
        next.clip = *scene::withBallRemoved({}, {10, 30, 5}, 40.0, volume());
    });
    ClipHandlesTool tool(*session_, *editing_);
    const auto ball = [&] { return *clipFor(*state().clip, volume()).ball; };
    ASSERT_TRUE(tool.press(placeOf({10, 30, 5})));
    tool.release(placeOf({-20, 30, 45}));
    EXPECT_LT(glm::distance(ball().centreMm, {-20, 30, 45}), 1e-6);
    EXPECT_NEAR(ball().radiusMm, 40.0, 1e-9);
    ASSERT_TRUE(tool.press(placeOf({20, 30, 45})));
    tool.release(placeOf({50, 30, 45}));
    EXPECT_NEAR(ball().radiusMm, 70.0, 1e-6);
    EXPECT_EQ(tool.point(placeOf({-20, 30, 45})), Qt::SizeAllCursor);
}

TEST_F(ClipToolsTest, ADragThatIsGivenUpStaysUndoableAndHoldsNothing) {
    openPhantom();
    editing_->setHandlesAskedFor(true);
    ClipHandlesTool tool(*session_, *editing_);
    glm::dvec3 top = all().centre();
    top.z = all().high.z;
    ASSERT_TRUE(tool.press(placeOf(top)));
    tool.move(placeOf(top - glm::dvec3(0, 0, 30)));
    tool.giveUp();
    const scene::StudyState held = state();
    tool.move(placeOf(top - glm::dvec3(0, 0, 90)));
    EXPECT_EQ(state(), held);
    session_->undo();
    EXPECT_FALSE(state().clip);
}

TEST_F(ClipToolsTest, TheWheelCutsDeeperFromTheEyeInOneStep) {
    openPhantom();
    ClipHandlesTool tool(*session_, *editing_);
    EXPECT_FALSE(tool.turnWheel(1.0, fromAnterior())) << "without handles the wheel is the camera's";
    editing_->setHandlesAskedFor(true);
    EXPECT_TRUE(tool.turnWheel(1.0, fromAnterior()));
    ASSERT_TRUE(state().cuts.eye);
    const double first = state().cuts.eye->fromMiddleMm;
    EXPECT_LT(first, 0.0) << "from before the volume";
    EXPECT_NEAR(state().cuts.eye->plane.normal.y, 1.0, 1e-12) << "what is anterior goes";
    EXPECT_TRUE(tool.turnWheel(5.0, fromAnterior()));
    EXPECT_GT(state().cuts.eye->fromMiddleMm, first);
    EXPECT_TRUE(tool.turnWheel(-1000.0, fromAnterior()));
    EXPECT_GE(state().cuts.eye->fromMiddleMm, scene::eyeCutRangeMm({0, 1, 0}, volume()).low - 1e-9);
    session_->undo();
    EXPECT_FALSE(session_->canUndo());
}

TEST_F(ClipToolsTest, TheCutFromTheEyeFollowsTheCameraOrStaysInThePatient) {
    openPhantom();
    session_->change("Cross-hair", [](scene::StudyState& next) { next.slices.crosshairMm = {5, -20, 7}; });
    ASSERT_TRUE(editing_->setEyeCut(true).ok());
    EXPECT_NEAR(state().cuts.eye->plane.offsetMm, -20.0, 1e-9) << "through the cross-hair";
    const Camera fromLeft{.positionMm = {3000, 0, 0}, .targetMm = {0, 0, 0}, .up = {0, 0, 1}};
    editing_->setCamera(fromLeft);
    EXPECT_NEAR(state().cuts.eye->plane.normal.x, -1.0, 1e-12);
    EXPECT_EQ(session_->undoText(), QLatin1String("Cut from the eye"));
    editing_->setFollowsCamera(false);
    editing_->setCamera(fromAnterior().camera);
    EXPECT_NEAR(state().cuts.eye->plane.normal.x, -1.0, 1e-12);
    editing_->setFollowsCamera(true);
    EXPECT_NEAR(state().cuts.eye->plane.normal.y, 1.0, 1e-12);
    ASSERT_TRUE(editing_->setEyeCut(false).ok());
    EXPECT_TRUE(state().cuts.isNothing());
}

TEST_F(ClipToolsTest, TheDepthOfTheCutOutlastsALookFromWhereTheVolumeIsThinner) {
    session_->show({.volume = std::make_shared<const Volume>(
                        phantom::make({.size = {24, 8, 16}, .spacingMm = {12, 12, 18}}))},
                   {});
    const Camera fromLeft{.positionMm = {3000, 0, 0}, .targetMm = {0, 0, 0}, .up = {0, 0, 1}};
    editing_->setCamera(fromLeft);
    ASSERT_TRUE(editing_->setEyeCut(true).ok());
    editing_->dragEyeCut(130.0);
    const scene::EyeCut before = *state().cuts.eye;
    EXPECT_NEAR(before.plane.offsetMm, 130.0, 1e-9);
    editing_->setCamera(fromAnterior().camera);
    const Volume& thin = *session_->study().volume;
    EXPECT_NEAR(state().cuts.eye->plane.offsetMm,
                thin.worldBox().centre().y + scene::eyeCutRangeMm({0.0, 1.0, 0.0}, thin).high, 1e-9)
        << "a voxel is left";
    editing_->setCamera(fromLeft);
    EXPECT_EQ(*state().cuts.eye, before);
    // The wheel goes on from what is seen.
    editing_->setCamera(fromAnterior().camera);
    const double seenMm = state().cuts.eye->plane.offsetMm;
    ASSERT_TRUE(editing_->stepEyeCut(-1.0).ok());
    EXPECT_LT(state().cuts.eye->plane.offsetMm, seenMm);
}

TEST_F(ClipToolsTest, WithoutAStudyNothingHappens) {
    ClipHandlesTool handles(*session_, *editing_);
    ScissorTool scissors(*editing_);
    editing_->setHandlesAskedFor(true);
    scissors.setOut(true);
    EXPECT_FALSE(handles.press(at(0, 0)));
    EXPECT_TRUE(handles.marks(fromAnterior()).empty());
    EXPECT_FALSE(handles.turnWheel(1.0, fromAnterior()));
    EXPECT_FALSE(editing_->setEyeCut(true).ok());
    EXPECT_FALSE(editing_->addScissorCut({.camera = {}, .outline = {{0, 0}, {1, 0}, {1, 1}}}).ok());
    editing_->setCamera({});
    EXPECT_FALSE(session_->canUndo());
}

TEST_F(ClipToolsTest, ScissorsCutWhatIsDrawnAround) {
    openPhantom();
    ScissorTool tool(*editing_);
    EXPECT_FALSE(tool.press(at(0, 0))) << "they are not out";
    tool.setOut(true);
    EXPECT_EQ(tool.point(at(0, 0)), Qt::CrossCursor);
    ASSERT_TRUE(tool.press(at(-0.2, -0.2)));
    for (const glm::dvec2 to : {glm::dvec2(0.2, -0.2), glm::dvec2(0.2, 0.2), glm::dvec2(-0.2, 0.2)})
        tool.move(at(to.x, to.y));
    EXPECT_GT(tool.marks(fromAnterior()).size(), 20u);
    EXPECT_LE(tool.marks(fromAnterior()).size(), kMostToolMarks);
    tool.release(at(-0.2, 0.2));
    EXPECT_TRUE(tool.marks(fromAnterior()).empty());
    ASSERT_EQ(state().cuts.scissors.size(), 1u);
    const scene::ScissorCut& cut = state().cuts.scissors[0];
    EXPECT_EQ(cut.camera, fromAnterior().camera);
    EXPECT_FALSE(cut.removesOutside);
    ASSERT_EQ(cut.outline.size(), 4u);
    EXPECT_NEAR(cut.outline[1].x, 0.2 * 1.25, 1e-12) << "half heights: the picture is wider than high";
    EXPECT_NEAR(cut.outline[1].y, -0.2, 1e-12);
    session_->undo();
    EXPECT_TRUE(state().cuts.isNothing());

    ASSERT_TRUE(tool.press(at(-0.2, -0.2)));
    tool.move(at(0.2, 0.0));
    PicturePlace last = at(-0.2, 0.3);
    last.withShift = true;
    tool.release(last);
    ASSERT_EQ(state().cuts.scissors.size(), 1u);
    EXPECT_TRUE(state().cuts.scissors[0].removesOutside);
}

TEST_F(ClipToolsTest, AClickOrAnotherCameraIsNoCut) {
    openPhantom();
    ScissorTool tool(*editing_);
    tool.setOut(true);
    ASSERT_TRUE(tool.press(at(0, 0)));
    tool.release(at(0.001, 0.001));
    EXPECT_FALSE(session_->canUndo());
    ASSERT_TRUE(tool.press(at(-0.2, -0.2)));
    tool.move(at(0.2, -0.2));
    PicturePlace elsewhere = at(0.2, 0.2);
    elsewhere.picture.camera.positionMm.x += 1.0;
    tool.move(elsewhere);
    tool.release(at(-0.2, 0.2));
    EXPECT_FALSE(session_->canUndo());
    ASSERT_TRUE(tool.press(at(-0.2, -0.2)));
    tool.move(at(0.2, 0.2));
    tool.setOut(false);
    tool.release(at(-0.2, 0.2));
    EXPECT_FALSE(session_->canUndo());
    // A line that is as long as a hand likes.
    tool.setOut(true);
    ASSERT_TRUE(tool.press(at(0.0, 0.0)));
    for (int i = 0; i < 30000; ++i)
        tool.move(at(0.9 * std::cos(i * 0.37) * (i % 97) / 97.0, 0.9 * std::sin(i * 0.37)));
    EXPECT_LE(tool.marks(fromAnterior()).size(), kMostToolMarks);
    tool.release(at(0.0, 0.0));
    ASSERT_EQ(state().cuts.scissors.size(), 1u);
    EXPECT_LE(state().cuts.scissors[0].outline.size(), scene::kMostOutlinePoints);
}

scene::ScissorCut square(double half, const glm::dvec2& middle = {0, 0}) {
    return {
        .camera = {.positionMm = {0, -3000, 0}, .targetMm = {0, 0, 0}, .up = {0, 0, 1}, .verticalFovDeg = 10},
        .outline = {middle + glm::dvec2(-half, -half), middle + glm::dvec2(half, -half),
                    middle + glm::dvec2(half, half), middle + glm::dvec2(-half, half)}};
}

TEST_F(ClipToolsTest, CuttingFindsWhatIsLeftAndGoesBackAtOnce) {
    openPhantom();
    VoxelCutting cutting(nullptr);
    cutting.setVolume(session_->study().volume);
    int changes = 0;
    QObject::connect(&cutting, &VoxelCutting::changed, &cutting, [&] { ++changes; });
    cutting.want({});
    EXPECT_EQ(changes, 0) << "nothing is cut already";
    cutting.want({square(0.2)});
    EXPECT_FALSE(cutting.mask()) << "until it is found";
    ASSERT_TRUE(waitUntil([&] { return !cutting.running(); }));
    EXPECT_EQ(changes, 1);
    ASSERT_TRUE(cutting.mask());
    cutting.want({square(0.2)});
    EXPECT_FALSE(cutting.running()) << "the same again";

    cutting.want({square(0.2), square(0.1, {0.3, 0.3})});
    ASSERT_TRUE(waitUntil([&] { return !cutting.running(); }));
    Progress progress;
    const auto together =
        scene::scissorMask({}, std::vector{square(0.2), square(0.1, {0.3, 0.3})}, volume(), progress);
    ASSERT_TRUE(together.ok() && *together);
    EXPECT_EQ(cutting.mask()->bits->words, (*together)->bits->words);
    EXPECT_EQ(changes, 2);
    cutting.want({});
    EXPECT_FALSE(cutting.mask());
    EXPECT_EQ(changes, 3);
}

TEST_F(ClipToolsTest, WhatCannotBeCutIsRefusedAndSaysWhatIsLeft) {
    openPhantom();
    VoxelCutting cutting(nullptr);
    cutting.setVolume(session_->study().volume);
    std::optional<std::vector<scene::ScissorCut>> had;
    std::optional<Error> error;
    QObject::connect(&cutting, &VoxelCutting::refused, &cutting, [&](const auto& cuts) { had = cuts; });
    QObject::connect(&cutting, &VoxelCutting::failed, &cutting, [&](const Error& e) { error = e; });
    cutting.want({square(0.2)});
    ASSERT_TRUE(waitUntil([&] { return !cutting.running(); }));
    EXPECT_FALSE(had);
    cutting.want({square(0.2), square(50.0)});
    ASSERT_TRUE(waitUntil([&] { return !cutting.running(); }));
    ASSERT_TRUE(had && error);
    EXPECT_EQ(*had, std::vector{square(0.2)});
    EXPECT_TRUE(cutting.mask()) << "of the first cut";
    cutting.want(*had);
    EXPECT_FALSE(cutting.running());
    had.reset();
    cutting.want({square(0.2), square(0.3)});
    cutting.cancel();
    ASSERT_TRUE(had);
    EXPECT_EQ(*had, std::vector{square(0.2)});
}

// An undo after it does not go back to the cut, which would be refused again and again.
TEST_F(ClipToolsTest, ARefusedOrCancelledCutIsNoStep) {
    ShownVolume shown(*session_);
    openPhantom();
    const auto ask = [&](const scene::ScissorCut& cut) {
        session_->change("Scissors", [&](scene::StudyState& next) { next.cuts.scissors.push_back(cut); });
    };
    ask(square(0.2));
    ASSERT_TRUE(waitUntil([&] { return !shown.cutting().running(); }));
    for (const bool isCancelled : {false, true}) {
        session_->change("Marks", [](scene::StudyState& next) { next.showsMarks = !next.showsMarks; });
        const scene::StudyState before = state();
        ask(square(isCancelled ? 0.3 : 50.0));
        EXPECT_EQ(session_->undoText(), QLatin1String("Scissors"));
        if (isCancelled) shown.cutting().cancel();
        ASSERT_TRUE(waitUntil([&] { return !shown.cutting().running(); }));
        EXPECT_EQ(state(), before);
        EXPECT_EQ(session_->undoText(), QLatin1String("Marks"));
        EXPECT_FALSE(session_->canRedo());
    }
    session_->undo();
    session_->undo();
    EXPECT_FALSE(shown.cutting().running());
    EXPECT_EQ(state().cuts.scissors, std::vector{square(0.2)});
    session_->undo();
    EXPECT_TRUE(state().cuts.scissors.empty());
    EXPECT_FALSE(session_->canUndo());
}

TEST_F(ClipToolsTest, WhereVoxelsCannotBeHiddenTheStateIsThatOfThePicture) {
    ShownVolume shown(*session_);
    openPhantom();
    const auto cut = [&](const std::vector<scene::ScissorCut>& scissors) {
        session_->change("Scissors", [&](scene::StudyState& next) { next.cuts.scissors = scissors; });
        return waitUntil([&] { return !shown.cutting().running(); });
    };
    ASSERT_TRUE(cut({square(0.2)}));
    const scene::StudyState before = state();
    // The cut is found, and cannot be joined with what else is hidden.
    shown.hidden().blockSignals(true);
    ASSERT_TRUE(cut({square(0.2), square(0.3)}));
    shown.hidden().blockSignals(false);
    Q_EMIT shown.hidden().failed({ErrorCode::outOfMemory, Text("There is not enough memory."), {}, {}});
    EXPECT_EQ(state(), before);
    ASSERT_TRUE(waitUntil([&] { return !shown.cutting().running(); }));
    EXPECT_EQ(shown.cutting().madeOf(), before.cuts.scissors);
    EXPECT_EQ(state(), before);
    session_->undo();
    EXPECT_TRUE(state().cuts.scissors.empty());
    EXPECT_FALSE(session_->canUndo());
}

// It would be kept, and all of the study lost with it the next time.
TEST_F(ClipToolsTest, AViewThatCouldNotBeReadAgainIsNotTaken) {
    ShownVolume shown(*session_);
    openPhantom();
    scene::StudyState view = state();
    view.preset = scene::builtInCatalogue()->presets.front();
    view.showsMarks = false;
    view.camera = fromAnterior().camera;
    view.camera->targetMm.y = 2e6;
    const auto far = shown.take(view);
    ASSERT_FALSE(far);
    EXPECT_EQ(far.error().code, ErrorCode::inputNotUsable);
    view.camera = fromAnterior().camera;
    auto fine = std::make_shared<TransferFunction>(*view.preset);
    fine->opacity.assign(5000, fine->opacity.front());
    view.preset = fine;
    EXPECT_FALSE(shown.take(view));
    EXPECT_TRUE(state().showsMarks);
    EXPECT_FALSE(session_->canUndo());
    view.preset = scene::builtInCatalogue()->presets.front();
    ASSERT_TRUE(shown.take(view));
    EXPECT_FALSE(state().showsMarks);
}

TEST_F(ClipToolsTest, MarksOfToolsAreLaidOverTheCube) {
    const auto cube = std::make_shared<const live::PictureText>(
        live::PictureText{.size = {3, 2},
                          .rgba = std::vector<std::byte>(24, std::byte{7}),
                          .boxes = {{{1, 1}, {2, 1}}},
                          .places = {{190, 90}}});
    EXPECT_EQ(withToolMarks(cube, {}, {200, 100}, 1.0), cube);
    EXPECT_EQ(withToolMarks(nullptr, {}, {200, 100}, 1.0), nullptr);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<ToolMark> marks{{.kind = MarkKind::handle, .place = {0, 0}},
                                      {.kind = MarkKind::dot, .place = {0.5, 0.5}},
                                      {.kind = MarkKind::handle, .place = {-0.5, -0.5}},
                                      {.kind = MarkKind::handle, .place = {nan, 0}},
                                      {.kind = MarkKind::handle, .place = {7, 0}}};
    const auto with = withToolMarks(cube, marks, {200, 100}, 1.0);
    ASSERT_TRUE(with);
    ASSERT_EQ(with->boxes.size(), 4u);
    ASSERT_EQ(with->places.size(), 4u);
    EXPECT_EQ(with->places[0].x, 190);
    EXPECT_EQ(with->places[0].y, 90);
    EXPECT_EQ(with->of.width, 200u) << "over no picture of another size";
    EXPECT_EQ(with->of.height, 100u);
    EXPECT_EQ(with->places[1].x, 100 - 6) << "its middle is there";
    EXPECT_EQ(with->places[1].y, 50 - 6);
    EXPECT_EQ(with->places[2].y, 25 - 1) << "up is positive";
    EXPECT_EQ(with->boxes[1].offset.y, with->boxes[3].offset.y) << "one image for all of a kind";
    EXPECT_EQ(with->rgba.size(), std::size_t(with->size.width) * with->size.height * 4);
    EXPECT_EQ(with->rgba[0], std::byte{7});
    for (const VkRect2D& box : with->boxes) {
        EXPECT_LE(std::uint32_t(box.offset.x) + box.extent.width, with->size.width);
        EXPECT_LE(std::uint32_t(box.offset.y) + box.extent.height, with->size.height);
    }
    const std::vector<ToolMark> many(2 * kMostToolMarks, marks[0]);
    EXPECT_EQ(withToolMarks(nullptr, many, {200, 100}, 1.0)->boxes.size(), kMostToolMarks);
}

class ClipWidgetsTest : public ClipToolsTest {
  protected:
    void SetUp() override {
        ClipToolsTest::SetUp();
        cuts_.emplace(*session_, *editing_);
        named_.emplace(*session_);
        cuts_->show();
        named_->show();
    }
    void TearDown() override {
        named_.reset();
        cuts_.reset();
    }
    template <class Widget>
    Widget& find(QWidget& in, const char* name) {
        auto* found = in.findChild<Widget*>(QLatin1String(name));
        if (found == nullptr) throw std::runtime_error(name);
        return *found;
    }
    QPushButton& button(const char* name) { return find<QPushButton>(*named_, name); }
    QListWidget& list() { return find<QListWidget>(*named_, "clip-named-list"); }
    QLineEdit& name() { return find<QLineEdit>(*named_, "clip-named-name"); }
    QString trouble() { return find<QLabel>(*named_, "clip-named-trouble").text(); }
    void save(const QString& as) {
        name().setText(as);
        QTest::mouseClick(&button("clip-named-save"), Qt::LeftButton);
    }

    std::optional<CutTools> cuts_;
    std::optional<NamedClips> named_;
};

TEST_F(ClipWidgetsTest, EveryControlHasANameAndATipAndSaysWhatItNeeds) {
    const auto check = [&] {
        for (QWidget* in : {static_cast<QWidget*>(&*cuts_), static_cast<QWidget*>(&*named_)}) {
            for (const QWidget* each : in->findChildren<QWidget*>()) {
                if (each->objectName().startsWith(QLatin1String("clip-")) &&
                    qobject_cast<const QLabel*>(each) == nullptr) {
                    EXPECT_FALSE(each->accessibleName().isEmpty()) << each->objectName().toStdString();
                    EXPECT_FALSE(each->toolTip().isEmpty()) << each->objectName().toStdString();
                }
            }
        }
    };
    check();
    EXPECT_FALSE(find<QCheckBox>(*cuts_, "clip-eye").isEnabled());
    EXPECT_TRUE(find<QCheckBox>(*cuts_, "clip-eye").toolTip().contains(QLatin1String("study")));
    EXPECT_FALSE(button("clip-named-save").isEnabled());
    openPhantom();
    check();
    EXPECT_TRUE(find<QCheckBox>(*cuts_, "clip-eye").isEnabled());
    EXPECT_FALSE(find<QDoubleSpinBox>(*cuts_, "clip-eye-depth").isEnabled()) << "there is no cut";
    EXPECT_FALSE(session_->canUndo()) << "what is shown proposes nothing";
}

TEST_F(ClipWidgetsTest, TheCutFromTheEyeIsSwitchedAndMoved) {
    openPhantom();
    auto& eye = find<QCheckBox>(*cuts_, "clip-eye");
    auto& depth = find<QDoubleSpinBox>(*cuts_, "clip-eye-depth");
    eye.click();
    ASSERT_TRUE(state().cuts.eye);
    EXPECT_TRUE(depth.isEnabled());
    depth.setValue(-30.0);
    EXPECT_NEAR(state().cuts.eye->fromMiddleMm, -30.0, 1e-9);
    find<QCheckBox>(*cuts_, "clip-eye-follows").click();
    EXPECT_FALSE(state().cuts.eye->followsCamera);
    session_->undo();
    session_->undo();
    session_->undo();
    EXPECT_FALSE(eye.isChecked());
    EXPECT_FALSE(session_->canUndo());
}

TEST_F(ClipWidgetsTest, SlicesShowTheClipOrNot) {
    openPhantom();
    EXPECT_TRUE(editing_->showsOnSlices());
    find<QCheckBox>(*cuts_, "clip-on-slices").click();
    EXPECT_FALSE(editing_->showsOnSlices());
}

TEST_F(ClipWidgetsTest, ClipsAreSavedAppliedRenamedAndDeleted) {
    openPhantom();
    session_->change("Clip", [&](scene::StudyState& next) {
        next.clip = *scene::withFace({}, scene::Face::left, 40.0, volume());
        next.cuts.scissors = {square(0.1)};
    });
    const scene::StudyState clipped = state();
    save(QStringLiteral("  heart "));
    ASSERT_EQ(state().namedClips.size(), 1u);
    EXPECT_EQ(state().namedClips[0].name, "heart");
    EXPECT_EQ(list().count(), 1);
    session_->change("Clip", [](scene::StudyState& next) {
        next.clip.reset();
        next.cuts = {};
    });
    list().setCurrentRow(0);
    QTest::mouseClick(&button("clip-named-apply"), Qt::LeftButton);
    EXPECT_EQ(state().clip, clipped.clip);
    EXPECT_EQ(state().cuts, clipped.cuts);

    save(QStringLiteral("spine"));
    ASSERT_EQ(state().namedClips.size(), 2u);
    EXPECT_EQ(list().currentRow(), 1);
    name().setText(QStringLiteral("heart"));
    QTest::mouseClick(&button("clip-named-rename"), Qt::LeftButton);
    EXPECT_FALSE(trouble().isEmpty()) << "names are unlike each other";
    EXPECT_EQ(state().namedClips[1].name, "spine");
    name().setText(QStringLiteral("back"));
    QTest::mouseClick(&button("clip-named-rename"), Qt::LeftButton);
    EXPECT_EQ(state().namedClips[1].name, "back");
    EXPECT_TRUE(trouble().isEmpty());
    QTest::mouseClick(&button("clip-named-delete"), Qt::LeftButton);
    ASSERT_EQ(state().namedClips.size(), 1u);
    EXPECT_EQ(state().clip, clipped.clip) << "what is shown stays";
    session_->undo();
    EXPECT_EQ(list().count(), 2);

    save(QStringLiteral("   "));
    EXPECT_EQ(state().namedClips.size(), 2u) << "no name";
    save(QStringLiteral("heart"));
    EXPECT_EQ(state().namedClips.size(), 2u) << "it takes the place of the one before";
}

}  // namespace
}  // namespace macula::viewer
