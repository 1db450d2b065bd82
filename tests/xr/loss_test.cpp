// Sessions and runtimes that are lost at whichever call: told in a sentence, and begun again with all in
// place.
#include <gtest/gtest.h>

#include "xr/openxr.h"
#include "xr/scripted_room.h"

namespace macula::xr {
namespace {

using LossTest = ScriptedRoom;

xr_script::Script losing(const std::string& call, XrResult answer) {
    xr_script::Script script;
    script.loseAt = call;
    script.loseNth = 4;
    script.answer = answer;
    return script;
}

TEST_F(LossTest, ALostSessionIsBegunAgainWhereItWas) {
    connect({});
    show();
    for (const char* call : {"xrPollEvent", "xrWaitFrame", "xrBeginFrame", "xrSyncActions", "xrLocateViews",
                             "xrLocateSpace", "xrGetActionStateFloat", "xrAcquireSwapchainImage",
                             "xrWaitSwapchainImage", "xrReleaseSwapchainImage", "xrEndFrame"}) {
        SCOPED_TRACE(call);
        const std::optional<glm::dmat4> placed = headset_->placed();
        xr_script::follow(losing(call, XR_ERROR_SESSION_LOST));
        std::optional<Error> error;
        for (int i = 0; i < 40 && !error; ++i) {
            const auto step = headset_->step();
            if (!step) error = step.error();
        }
        ASSERT_TRUE(error);
        EXPECT_EQ(error->code, ErrorCode::deviceLost);
        EXPECT_NE(error->message.english().find("ended the session"), std::string::npos) << error->message;
        EXPECT_FALSE(error->hint.empty());

        const std::optional<glm::dmat4> then = headset_->placed();
        headset_.reset();
        EXPECT_EQ(xr_script::record().sessions, 0);
        EXPECT_EQ(xr_script::record().swapchains, 0);
        EXPECT_EQ(xr_script::record().violations, std::vector<std::string>{});
        xr_script::follow({});
        open(then);
        frames(3);
        EXPECT_EQ(lastFrame().views.size(), 2u);
        if (placed) {
            EXPECT_EQ(headset_->placed(), placed);
        }
    }
}

TEST_F(LossTest, ALostRuntimeIsConnectedAgainWithWhatWasCut) {
    connect({});
    show();
    frames(3);
    ASSERT_TRUE(expectOk(view_->cut({.normal = {1, 0, 0}, .offsetMm = markerMm().x})));
    const RoomScene kept = view_->scene();
    const std::optional<glm::dmat4> placed = headset_->placed();
    xr_script::follow(losing("xrWaitFrame", XR_ERROR_INSTANCE_LOST));
    std::optional<Error> error;
    for (int i = 0; i < 40 && !error; ++i) {
        const auto step = headset_->step();
        if (!step) error = step.error();
    }
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code, ErrorCode::deviceLost);
    EXPECT_NE(error->message.english().find("has stopped"), std::string::npos) << error->message;
    headset_.reset();
    view_.reset();
    EXPECT_EQ(opened_->instance.validationMessageCount(), 0u);
    opened_.reset();
    runtime_.reset();

    connect({});
    view_.emplace(expectOk(RoomView::create(opened_->device, kept, std::make_shared<hybrid::ModelShelf>(1),
                                            {.model = {}, .learns = false})));
    open(placed);
    frames(3);
    EXPECT_EQ(headset_->placed(), placed);
    EXPECT_EQ(view_->scene().drawing.clip->planes.size(), 1u);
}

TEST_F(LossTest, ARuntimeThatLacksAFunctionIsToldAndLeavesNothingBehind) {
    xr_script::Script broken;
    broken.lacks = "xrCreateVulkanDeviceKHR";
    xr_script::follow(broken);
    const auto refused = Runtime::connect();
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::deviceNotUsable);
    EXPECT_NE(refused.error().message.english().find("OpenXR 1.0"), std::string::npos)
        << refused.error().message;
    EXPECT_EQ(xr_script::record().instances, 0);
    xr_script::follow({});
    EXPECT_TRUE(Runtime::connect().ok()) << "it was updated";
}

TEST_F(LossTest, AHeadsetThatIsGoneIsTold) {
    connect({});
    xr_script::Script gone;
    gone.hasHeadset = false;
    xr_script::follow(gone);
    const Result<void> found = runtime_->findHeadset();
    ASSERT_FALSE(found.ok());
    EXPECT_EQ(found.error().code, ErrorCode::deviceNotUsable);
    EXPECT_NE(found.error().message.english().find("No headset is connected"), std::string::npos);
    xr_script::follow({});
    EXPECT_TRUE(runtime_->findHeadset().ok()) << "it is plugged in again";
}

}  // namespace
}  // namespace macula::xr
