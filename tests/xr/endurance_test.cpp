// Many frames, many sessions, and losses at random calls: nothing is left behind, and nothing is forgotten.
//
// A few of each; for a night: MACULA_XR_FRAMES=2000 MACULA_XR_RESTARTS=1000 MACULA_XR_LOSSES=100.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <random>

#include "xr/openxr.h"
#include "xr/scripted_room.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
extern "C" std::size_t __sanitizer_get_current_allocated_bytes();  // GCC 12 has no header of it
#endif

namespace macula::xr {
namespace {

using xr_script::Script;
using xr_script::SubmittedFrame;

constexpr double kRate = 30.0;

std::uint64_t wantedCount(const char* name, std::uint64_t few) {
    const char* text = std::getenv(name);
    const long long count = text ? std::atoll(text) : 0;
    return count > 0 ? std::uint64_t(count) : few;
}

// In memory now. A sanitizer holds back for a while what was freed, and notes things about each byte:
// there, what is allocated.
double heldMb() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    return double(__sanitizer_get_current_allocated_bytes()) / (1024.0 * 1024.0);
#else
    std::ifstream file("/proc/self/statm");
    double all = 0.0;
    double resident = 0.0;
    file >> all >> resident;
    return resident * double(sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
#endif
}

xr_script::Pose headAt(double seconds) {
    return {{0.08 * std::sin(1.3 * seconds), 1.6 + 0.03 * std::sin(2.1 * seconds), 0.1 * std::sin(seconds)},
            glm::angleAxis(0.2 * std::sin(0.7 * seconds), glm::normalize(glm::dvec3(0.3, 1.0, 0.1)))};
}

// Head, eyes and hands move; the left hand grabs now and then, the right one cuts beside the anatomy or into
// it.
Script moving() {
    Script script;
    script.framesPerS = kRate;
    script.offersDepth = true;
    script.offersMask = true;
    script.hidden = {{-0.7, 0.7}, {-0.4, 0.7}, {-0.7, 0.4}};
    script.head = headAt;
    script.foreseenAsideM = [](int asked) { return asked == 0 ? 0.002 : 0.0; };
    script.gaze = [](double seconds) -> std::optional<xr_script::Pose> {
        if (std::fmod(seconds, 3.0) > 2.8) return std::nullopt;  // a blink
        const xr_script::Pose head = headAt(seconds);
        return xr_script::Pose{head.positionM,
                               head.orientation * glm::angleAxis(0.3 * std::sin(5.0 * seconds),
                                                                 glm::normalize(glm::dvec3(0.4, 1.0, 0.0)))};
    };
    script.hand = [](double seconds, int hand) {
        xr_script::Hand made;
        made.pose.positionM = {hand == 0 ? -0.3 : 0.3 + 0.02 * std::sin(seconds), 1.5, -0.3};
        made.pose.orientation = glm::angleAxis(0.5 * std::sin(seconds), glm::dvec3(0, 0, 1));
        const double phase = std::fmod(seconds, 2.0);
        if (hand == 0) made.squeeze = phase > 0.5 && phase < 1.0 ? 1.0f : 0.0f;
        if (hand == 1) made.trigger = phase > 1.2 && phase < 1.4 ? 1.0f : 0.0f;
        made.isTracked = std::fmod(seconds, 5.0) < 4.9;
        return std::optional(made);
    };
    return script;
}

class EnduranceTest : public ScriptedRoom {
  protected:
    static void expectNothingHeld() {
        const xr_script::Record record = xr_script::record();
        EXPECT_EQ(record.sessions, 0);
        EXPECT_EQ(record.swapchains, 0);
        EXPECT_EQ(record.spaces, 0);
        EXPECT_EQ(record.actionSets, 0);
        EXPECT_EQ(record.violations, std::vector<std::string>{});
    }
    // After a runtime that has stopped, with all that was shown.
    void connectAgain(const Script& script) {
        const RoomScene kept = view_->scene();
        view_.reset();
        EXPECT_EQ(opened_->instance.validationMessageCount(), 0u);
        opened_.reset();
        runtime_.reset();
        connect(script);
        view_.emplace(expectOk(RoomView::create(
            opened_->device, kept, std::make_shared<hybrid::ModelShelf>(1), {.model = {}, .learns = false})));
    }
};

TEST_F(EnduranceTest, ManyFramesAreInOrder) {
    const std::uint64_t wanted = wantedCount("MACULA_XR_FRAMES", 60);
    options_.holdsRate = true;
    connect(moving());
    show({.model = quickModel(), .learns = true});
    std::uint64_t checked = 0;
    while (checked < wanted) {
        // Fewer than the runtime remembers.
        const std::uint64_t count = std::min<std::uint64_t>(wanted - checked, xr_script::kMostFrames / 2);
        frames(count);
        const xr_script::Record record = xr_script::record();
        ASSERT_EQ(record.violations, std::vector<std::string>{});
        ASSERT_EQ(record.waited, record.begun);
        ASSERT_EQ(record.begun, record.ended);
        for (std::size_t i = record.frames.size() - count; i < record.frames.size(); ++i) {
            const SubmittedFrame& frame = record.frames[i];
            ASSERT_EQ(frame.number, checked++);
            ASSERT_NEAR(frame.seconds, double(frame.number) / kRate, 1e-6);
            ASSERT_EQ(frame.views.size(), 2u);
            const xr_script::Pose head = headAt(frame.seconds);
            for (std::size_t eye = 0; eye < 2; ++eye) {
                const glm::dvec3 at =
                    head.positionM + head.orientation * glm::dvec3(eye == 0 ? -0.032 : 0.032, 0.0, 0.0);
                ASSERT_NEAR(glm::distance(frame.views[eye].pose.positionM, at), 0.0, 1e-5);
                ASSERT_EQ(frame.views[eye].rgba[0], glm::u8vec4(0)) << "no lens shows it";
                if (frame.views[eye].depth) {
                    for (const float depth : frame.views[eye].depth->depths)
                        ASSERT_TRUE(depth >= 0.0f && depth <= 1.0f);
                }
            }
        }
    }
    EXPECT_EQ(headset_->session().unsubmitted(), 0u);
}

TEST_F(EnduranceTest, SessionsBeginAndEndWithoutALeak) {
    const std::uint64_t wanted = wantedCount("MACULA_XR_RESTARTS", 20);
    Script script = moving();
    script.hand = {};  // what nobody grabs stays where it is
    connect(script);
    show();
    frames(3);
    const std::optional<glm::dmat4> placed = headset_->placed();
    ASSERT_TRUE(placed);
    double quarterMb = 0.0;
    for (std::uint64_t i = 0; i < wanted; ++i) {
        headset_.reset();
        expectNothingHeld();
        open(placed);
        frames(2);
        ASSERT_EQ(lastFrame().views.size(), 2u) << i;
        ASSERT_EQ(headset_->placed(), placed) << i;
        if (i % 3 == 0) {  // it was asked to end, and did
            expectOk(headset_->requestEnd());
            bool hasEnded = false;
            for (int k = 0; k < 20 && !hasEnded; ++k)
                hasEnded = expectOk(headset_->step()) == Headset::Step::ended;
            ASSERT_TRUE(hasEnded) << i;
        }
        if (i == wanted / 4) quarterMb = heldMb();
    }
    EXPECT_LT(heldMb(), quarterMb + 48.0);
}

TEST_F(EnduranceTest, LossesAtRandomCallsLeaveNothingAndLoseNothing) {
    const std::uint64_t wanted = wantedCount("MACULA_XR_LOSSES", 12);
    constexpr const char* kCalls[] = {"xrCreateSession",
                                      "xrCreateReferenceSpace",
                                      "xrCreateActionSet",
                                      "xrCreateAction",
                                      "xrCreateActionSpace",
                                      "xrAttachSessionActionSets",
                                      "xrCreateSwapchain",
                                      "xrEnumerateSwapchainFormats",
                                      "xrBeginSession",
                                      "xrPollEvent",
                                      "xrWaitFrame",
                                      "xrBeginFrame",
                                      "xrSyncActions",
                                      "xrLocateViews",
                                      "xrLocateSpace",
                                      "xrGetActionStateFloat",
                                      "xrGetVisibilityMaskKHR",
                                      "xrAcquireSwapchainImage",
                                      "xrWaitSwapchainImage",
                                      "xrReleaseSwapchainImage",
                                      "xrEndFrame"};
    std::mt19937 random(31);
    Script still = moving();
    still.hand = {};  // nobody moves or cuts it meanwhile
    connect(still);
    show();
    frames(3);
    ASSERT_TRUE(expectOk(view_->cut({.normal = {1, 0, 0}, .offsetMm = markerMm().x})));
    const std::optional<glm::dmat4> placed = headset_->placed();
    headset_.reset();
    std::uint64_t lost = 0;
    for (std::uint64_t round = 0; round < wanted; ++round) {
        Script script = still;
        script.loseAt = kCalls[random() % std::size(kCalls)];
        script.loseNth = 1 + int(random() % 8);
        const bool isRuntime = random() % 4 == 0;
        script.answer = isRuntime ? XR_ERROR_INSTANCE_LOST : XR_ERROR_SESSION_LOST;
        SCOPED_TRACE(script.loseAt + " " + std::to_string(script.loseNth) + (isRuntime ? " runtime" : ""));
        xr_script::follow(script);
        std::optional<Error> error;
        auto opened = Headset::open(runtime_, opened_->device, *view_, placed, options_);
        if (opened) {
            std::optional<Headset> headset(std::move(*opened));
            for (int i = 0; i < 12 && !error; ++i) {
                const auto step = headset->step();
                if (!step) error = step.error();
            }
            EXPECT_EQ(headset->placed(), placed);
        } else {
            error = opened.error();
        }
        if (error) {
            ++lost;
            EXPECT_EQ(error->code, ErrorCode::deviceLost) << error->message;
            EXPECT_FALSE(error->hint.empty());
        }
        expectNothingHeld();

        script.loseAt.clear();
        if (isRuntime && error)
            connectAgain(script);
        else
            xr_script::follow(script);
        open(placed);
        frames(2);
        EXPECT_EQ(lastFrame().views.size(), 2u);
        EXPECT_EQ(headset_->placed(), placed);
        ASSERT_NE(view_->scene().drawing.clip, nullptr);
        EXPECT_EQ(view_->scene().drawing.clip->planes.size(), 1u);
        headset_.reset();
        expectNothingHeld();
    }
    EXPECT_GE(lost, wanted / 3);
}

}  // namespace
}  // namespace macula::xr
