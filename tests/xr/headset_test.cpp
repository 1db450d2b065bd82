// A study in the scripted headset: order, pictures, gaze and hands.
#include "xr/headset.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <stdexcept>

#include "pipeline/gpu/transfer.h"
#include "xr/scripted_room.h"

namespace macula::xr {
namespace {

using xr_script::Script;

constexpr double kRate = 30.0;

class HeadsetTest : public ScriptedRoom {
  protected:
    static Script still() {
        Script script;
        script.framesPerS = kRate;
        return script;
    }
    static xr_script::Pose swaying(double seconds) {
        return {{0.05 * std::sin(3.0 * seconds), 1.6 + 0.02 * std::sin(5.0 * seconds), 0.0},
                glm::angleAxis(0.1 * std::sin(2.0 * seconds), glm::dvec3(0, 1, 0))};
    }
    // Until the model can be drawn.
    void findModel() {
        for (int i = 0; i < 2000 && !view_->model().canBeDrawn(); ++i)
            expectOk(view_->model().work(20.0, [] { return true; }));
        ASSERT_TRUE(view_->model().canBeDrawn());
    }
    static glm::dvec2 centreOfLight(const xr_script::SubmittedView& view) {
        glm::dvec2 sum(0.0);
        double weight = 0.0;
        for (int y = 0; y < view.sizePx.y; ++y) {
            for (int x = 0; x < view.sizePx.x; ++x) {
                const double light =
                    view.rgba[std::size_t(y) * std::size_t(view.sizePx.x) + std::size_t(x)].y;
                sum += light * glm::dvec2(x + 0.5, y + 0.5);
                weight += light;
            }
        }
        EXPECT_GT(weight, 0.0);
        return sum / weight;
    }
    // Where a submitted view, by its pose and angles, has to show a point of the stage.
    static glm::dvec2 expectedPx(const xr_script::SubmittedView& view, const glm::dvec3& stageM) {
        const glm::dvec3 p = glm::inverse(view.pose.orientation) * (stageM - view.pose.positionM);
        const double left = std::tan(view.field.left);
        const double up = std::tan(view.field.up);
        return {(p.x / -p.z - left) / (std::tan(view.field.right) - left) * view.sizePx.x,
                (up - p.y / -p.z) / (up - std::tan(view.field.down)) * view.sizePx.y};
    }
};

TEST_F(HeadsetTest, ThirtyFramesOfAMovingHeadAreInOrder) {
    Script script = still();
    script.head = swaying;
    script.shouldRender = [](std::uint64_t frame) { return frame % 10 != 9; };
    connect(script);
    EXPECT_EQ(runtime_->offer().headset, "Scripted headset");
    EXPECT_EQ(runtime_->offer().eyePx, glm::ivec2(64));
    EXPECT_TRUE(runtime_->offer().hasGaze);
    show();
    frames(30);
    const xr_script::Record record = xr_script::record();
    EXPECT_EQ(record.waited, 30u);
    EXPECT_EQ(record.begun, 30u);
    EXPECT_EQ(record.ended, 30u);
    EXPECT_EQ(record.swapchains, 1);
    ASSERT_EQ(record.frames.size(), 30u);
    for (const xr_script::SubmittedFrame& frame : record.frames) {
        ASSERT_EQ(frame.views.size(), frame.number % 10 != 9 ? 2u : 0u) << frame.number;
        for (std::size_t eye = 0; eye < frame.views.size(); ++eye) {
            // For the time when it is seen.
            const xr_script::Pose head = swaying(frame.seconds);
            const glm::dvec3 at =
                head.positionM + head.orientation * glm::dvec3(eye == 0 ? -0.032 : 0.032, 0.0, 0.0);
            EXPECT_NEAR(glm::distance(frame.views[eye].pose.positionM, at), 0.0, 1e-6);
            EXPECT_EQ(frame.views[eye].sizePx, glm::ivec2(64));
            EXPECT_NEAR(frame.views[eye].field.left, -0.6, 1e-6);
        }
    }
}

TEST_F(HeadsetTest, ARuntimeThatLendsNoImageOfItsOwnIsToldOf) {
    connect(still());
    show();
    frames(3);
    Script broken = still();
    broken.lendsUnknownImage = true;
    xr_script::follow(broken);
    std::optional<Error> error;
    for (int i = 0; i < 4 && !error; ++i)
        if (const auto step = headset_->step(); !step) error = step.error();
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code, ErrorCode::deviceNotUsable);
    EXPECT_NE(error->message.english().find("lend a picture"), std::string::npos) << error->message;
    EXPECT_EQ(xr_script::record().begun, xr_script::record().ended) << "its frame was ended";
}

TEST_F(HeadsetTest, ARuntimeThatTakesNoLayersGetsTwoSwapchains) {
    Script script = still();
    script.takesLayers = false;
    script.hasStage = false;
    script.offersGaze = false;
    connect(script);
    EXPECT_FALSE(runtime_->offer().hasGaze);
    show();
    frames(4);
    EXPECT_EQ(xr_script::record().swapchains, 2);
    EXPECT_EQ(lastFrame().views.size(), 2u);
}

// Bit by bit but for the rounding of poses: with a field that is not even, of splats and fovea.
TEST_F(HeadsetTest, BothEyesArePicturesOfTheFacade) {
    Script script = still();
    script.head = swaying;
    // Who asks early is told a place that is 40 mm off: pictures are of where the eyes are said to be last.
    script.foreseenAsideM = [](int asked) { return asked == 0 ? 0.04 : 0.0; };
    script.eyePx = {72, 60};
    script.fields[0] = {-0.35f, 0.2f, 0.2f, -0.25f};
    script.fields[1] = {-0.2f, 0.35f, 0.2f, -0.25f};
    connect(script);
    show({.model = quickModel(), .learns = true});
    // Five times as large as it is, so that it covers many pixels.
    glm::dmat4 placed = stageFromWorldBefore({{0.0, 1.6, 0.0}, {1, 0, 0, 0}}, view_->seenMm());
    placed = glm::scale(placed, glm::dvec3(5.0));
    placed[3] = glm::dvec4(glm::dvec3(0.0, 1.6, -0.4) - glm::dmat3(placed) * view_->seenMm().centre(), 1.0);
    open(placed);
    frames(3);
    findModel();
    traceAll(headset_->shown()->eyes, 4);

    // The cameras of the next frame, from the script alone.
    const double seconds = double(xr_script::record().waited) / kRate;
    const xr_script::Pose head = swaying(seconds);
    std::vector<Eye> eyes;
    for (int i = 0; i < 2; ++i) {
        const xr_script::Field& field = script.fields[std::size_t(i)];
        eyes.push_back({{head.positionM + head.orientation * glm::dvec3(i == 0 ? -0.032 : 0.032, 0.0, 0.0),
                         head.orientation},
                        std::tan(field.left),
                        std::tan(field.right),
                        std::tan(field.up),
                        std::tan(field.down)});
    }
    const EyePictures pictures = expectOk(picturesFor(eyes, glm::inverse(*headset_->placed()), script.eyePx));
    hybrid::FrameRequest request;
    for (const EyePicture& eye : pictures.eyes) request.eyes.push_back(eye.camera);
    request.sizePx = pictures.sizePx;
    view_->setNear(nearMmOf(*headset_->placed()));
    const hybrid::Frame drawn = expectOk(view_->frame().draw(request, view_->periphery()));
    std::vector<std::vector<glm::u8vec4>> expected;
    for (const gpu::Image* picture : drawn.pictures)
        expected.push_back(expectOk(gpu::read<glm::u8vec4>(*picture)));

    frames(1);
    const xr_script::SubmittedFrame shown = lastFrame();
    EXPECT_NEAR(shown.seconds, seconds, 1e-6);
    ASSERT_EQ(shown.views.size(), 2u);
    for (std::size_t eye = 0; eye < 2; ++eye) {
        const glm::ivec2 part = pictures.eyes[eye].partPx;
        const glm::ivec2 first = pictures.eyes[eye].firstPx;
        ASSERT_EQ(shown.views[eye].sizePx, part);
        int brightest = 0;
        int different = 0;
        for (int y = 0; y < part.y; ++y) {
            for (int x = 0; x < part.x; ++x) {
                const glm::ivec4 wanted(
                    expected[eye][std::size_t(first.y + y) * std::size_t(pictures.sizePx.x) +
                                  std::size_t(first.x + x)]);
                const glm::ivec4 got(
                    shown.views[eye].rgba[std::size_t(y) * std::size_t(part.x) + std::size_t(x)]);
                brightest = std::max(brightest, got.y);
                const glm::ivec4 off = glm::abs(wanted - got);
                if (std::max({off.x, off.y, off.z}) > 2) ++different;
                EXPECT_EQ(got.w, 255);
            }
        }
        EXPECT_GT(brightest, 100) << "nothing is seen by eye " << eye;
        EXPECT_LE(different, part.x * part.y / 100) << "eye " << eye;
    }
}

// Where each eye sees the marker, and so how far away it seems.
TEST_F(HeadsetTest, TheMarkerHasTheDisparityOfItsDepth) {
    Script script = still();
    script.eyePx = {128, 128};
    for (xr_script::Field& field : script.fields) field = {-0.16f, 0.16f, 0.16f, -0.16f};
    connect(script);
    show();
    frames(3);
    traceAll(headset_->shown()->eyes, 8);
    frames(1);
    const xr_script::SubmittedFrame shown = lastFrame();
    ASSERT_EQ(shown.views.size(), 2u);
    const glm::dvec3 markerM = transformPoint(*headset_->placed(), markerMm());
    std::array<glm::dvec2, 2> found;
    std::array<glm::dvec2, 2> expected;
    for (std::size_t eye = 0; eye < 2; ++eye) {
        found[eye] = centreOfLight(shown.views[eye]);
        expected[eye] = expectedPx(shown.views[eye], markerM);
        EXPECT_NEAR(found[eye].x, expected[eye].x, 0.5) << eye;
        EXPECT_NEAR(found[eye].y, expected[eye].y, 0.5) << eye;
    }
    EXPECT_GT(expected[0].x - expected[1].x, 30.0) << "it is near";
    EXPECT_NEAR(found[0].x - found[1].x, expected[0].x - expected[1].x, 0.5);
}

TEST_F(HeadsetTest, TheFoveaFollowsTheGaze) {
    constexpr double kAsideDeg = 14.0;
    Script script = still();
    for (xr_script::Field& field : script.fields) field = {-0.7f, 0.7f, 0.7f, -0.7f};
    const auto looking = std::make_shared<double>(0.0);  // degrees to the right
    script.gaze = [looking](double) -> std::optional<xr_script::Pose> {
        return xr_script::Pose{{0.0, 1.6, 0.0}, glm::angleAxis(glm::radians(-*looking), glm::dvec3(0, 1, 0))};
    };
    connect(script);
    show({.model = quickModel(), .learns = true});
    frames(3);
    findModel();
    view_->frame().forgetFovea();
    const auto middleOfFovea = [&](double degrees) {
        *looking = degrees;
        frames(2);  // what was begun before is for where they looked before
        for (int i = 0; i < 200 && view_->frame().isTracing(); ++i) frames(1);
        frames(6);
        EXPECT_NEAR(headset_->shown()->gaze.x, std::tan(glm::radians(degrees)) / std::tan(0.7), 1e-5);
        if (headset_->shown()->frame.foveaWeights == nullptr) throw std::runtime_error("there is no fovea");
        const glm::ivec2 sizePx = headset_->shown()->eyes.sizePx;
        const auto weights = expectOk(gpu::read<float>(*headset_->shown()->frame.foveaWeights));
        double sum = 0.0;
        double all = 0.0;
        for (int y = 0; y < sizePx.y; ++y) {
            for (int x = 0; x < sizePx.x; ++x) {
                const double weight = weights[std::size_t(y) * std::size_t(sizePx.x) + std::size_t(x)];
                sum += weight * ((x + 0.5) / sizePx.x * 2.0 - 1.0);
                all += weight;
            }
        }
        EXPECT_GT(all, 0.0);
        return sum / all;
    };
    const double right = middleOfFovea(kAsideDeg);
    const double left = middleOfFovea(-kAsideDeg);
    // Both are as far to the left in the picture of the right eye as what is near is.
    EXPECT_GT(right, 0.05);
    EXPECT_LT(left, -0.2);
    EXPECT_NEAR(right - left, 2.0 * std::tan(glm::radians(kAsideDeg)) / std::tan(0.7), 0.15);
}

TEST_F(HeadsetTest, HandsMoveScaleAndCut) {
    Script script = still();
    const auto hands = std::make_shared<std::array<std::optional<xr_script::Hand>, 2>>();
    script.hand = [hands](double, int hand) { return (*hands)[std::size_t(hand)]; };
    connect(script);
    show();
    frames(3);  // until the session has the focus
    const glm::dmat4 placed = *headset_->placed();
    const auto hand = [](double x, float squeeze, float trigger = 0.0f) {
        xr_script::Hand made;
        made.pose.positionM = {x, 1.6, -0.4};
        made.squeeze = squeeze;
        made.trigger = trigger;
        return made;
    };
    (*hands)[1] = hand(0.2, 1.0f);
    frames(2);
    (*hands)[1] = hand(0.3, 1.0f);
    frames(1);
    EXPECT_NEAR(glm::distance(glm::dvec3((*headset_->placed())[3]) - glm::dvec3(placed[3]),
                              glm::dvec3(0.1, 0.0, 0.0)),
                0.0, 1e-6);
    (*hands)[0] = hand(0.1, 1.0f);
    frames(2);
    (*hands)[0] = hand(-0.1, 1.0f);
    frames(1);
    EXPECT_NEAR(scaleOf(*headset_->placed()), 2.0, 1e-5);
    (*hands)[0].reset();
    (*hands)[1] = hand(0.3, 0.0f);
    frames(2);

    // Through the middle of the marker, which stays in part.
    ASSERT_EQ(view_->scene().drawing.clip, nullptr);
    const double markerX = transformPoint(*headset_->placed(), markerMm()).x;
    (*hands)[1] = hand(markerX, 0.0f, 1.0f);
    frames(2);
    EXPECT_EQ(view_->scene().drawing.clip, nullptr) << "not before the trigger is let go";
    (*hands)[1] = hand(markerX, 0.0f, 0.0f);
    frames(2);
    ASSERT_NE(view_->scene().drawing.clip, nullptr);
    ASSERT_EQ(view_->scene().drawing.clip->planes.size(), 1u);
    EXPECT_NEAR(view_->scene().drawing.clip->planes[0].offsetMm, -markerMm().x, 1e-3);
    EXPECT_FALSE(shows(*view_->scene().drawing.clip, markerMm() + glm::dvec3(1, 0, 0)));
    EXPECT_TRUE(shows(*view_->scene().drawing.clip, markerMm() - glm::dvec3(1, 0, 0)));

    // What would remove all is not done.
    (*hands)[1] = hand(markerX - 0.2, 0.0f, 1.0f);
    frames(2);
    (*hands)[1] = hand(markerX - 0.2, 0.0f, 0.0f);
    frames(2);
    EXPECT_EQ(view_->scene().drawing.clip->planes.size(), 1u);
    EXPECT_EQ(lastFrame().views.size(), 2u);
}

// A runtime that says where things are in numbers that are none.
TEST_F(HeadsetTest, WhatIsNoPlaceIsAnEmptyFrameOrNoHand) {
    const double none = std::nan("");
    Script script = still();
    const auto head = std::make_shared<xr_script::Pose>();
    const auto hand = std::make_shared<xr_script::Hand>();
    head->positionM = {none, 1.6, 0.0};
    hand->pose.positionM = {0.2, 1.6, -0.4};
    script.head = [head](double) { return *head; };
    script.hand = [hand](double, int) { return std::optional(*hand); };
    connect(script);
    show();
    frames(2);
    EXPECT_TRUE(lastFrame().views.empty());
    EXPECT_FALSE(headset_->placed()) << "nobody knows where it is to stand";
    *head = {{0.0, 1.6, 0.0}, {1.0, 0.0, 0.0, 0.0}};
    frames(3);
    EXPECT_EQ(lastFrame().views.size(), 2u);
    const glm::dmat4 placed = *headset_->placed();

    hand->squeeze = hand->trigger = 1.0f;
    hand->pose.orientation = glm::dquat(none, none, none, none);
    frames(2);
    hand->pose.orientation = glm::dquat(0.0, 0.0, 0.0, 0.0);
    frames(2);
    EXPECT_EQ(*headset_->placed(), placed);
    EXPECT_EQ(lastFrame().views.size(), 2u);
    head->orientation = glm::dquat(0.0, 0.0, 0.0, 0.0);
    frames(1);
    EXPECT_TRUE(lastFrame().views.empty());
}

TEST_F(HeadsetTest, EndsWhenItIsTakenOff) {
    connect(still());
    show();
    frames(5);
    xr_script::requestEnd();
    bool hasEnded = false;
    for (int i = 0; i < 20 && !hasEnded; ++i) hasEnded = expectOk(headset_->step()) == Headset::Step::ended;
    EXPECT_TRUE(hasEnded);
    // And when we want it.
    open(headset_->placed());
    frames(3);
    expectOk(headset_->requestEnd());
    hasEnded = false;
    for (int i = 0; i < 20 && !hasEnded; ++i) hasEnded = expectOk(headset_->step()) == Headset::Step::ended;
    EXPECT_TRUE(hasEnded);
}

TEST_F(HeadsetTest, WhatCannotBeShownIsRefusedInWords) {
    connect(still());
    const auto shelf = std::make_shared<hybrid::ModelShelf>(1);
    const auto refused = [&](RoomScene wrong) {
        const auto view = RoomView::create(opened_->device, std::move(wrong), shelf);
        EXPECT_FALSE(view.ok());
        return view.ok() ? Error{} : view.error();
    };
    RoomScene wrong = scene();
    wrong.drawing.settings.look = trace::Look::mip;
    EXPECT_EQ(refused(wrong).code, ErrorCode::usage);
    wrong = scene();
    trace::LightRig hanging = *wrong.drawing.lights;
    hanging.frame = trace::LightFrame::camera;
    wrong.drawing.lights = std::make_shared<const trace::LightRig>(hanging);
    EXPECT_EQ(refused(wrong).code, ErrorCode::usage);
    wrong = scene();
    wrong.drawing.transferFunction =
        std::make_shared<const TransferFunction>(scenes::ramp(5000, 6000, 0.9, 1.0));
    EXPECT_EQ(refused(wrong).code, ErrorCode::inputNotUsable);
}

}  // namespace
}  // namespace macula::xr
