// A marker in a room, and the scripted headset around it.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <optional>

#include "gpu/gpu_test.h"
#include "trace/extreme_scenes.h"
#include "xr/headset.h"
#include "xr/placement.h"
#include "xr/runtime/script.h"

namespace macula::xr {

using gpu::expectOk;

class ScriptedRoom : public ::testing::Test {
  protected:
    static constexpr glm::ivec3 kVoxels{48, 48, 48};
    static constexpr double kMarkerMm = 4.0;
    // A ball to the patient's left of the middle, above it and in front of it.
    const glm::dvec3 markerVoxel_{29.0, 19.0, 27.0};

    void SetUp() override { setenv("XR_RUNTIME_JSON", MACULA_XR_MANIFEST, 1); }

    // Nothing that the application did was wrong, and it left nothing behind.
    void TearDown() override {
        std::vector<std::string> messages;
        if (opened_) {
            expectOk(opened_->device->waitForAll());
            headset_.reset();
            view_.reset();
            opened_->device.reset();
            messages = opened_->instance.validationMessages();
        }
        for (const std::string& message : messages) ADD_FAILURE() << message;
        const xr_script::Record record = xr_script::record();
        for (const std::string& violation : record.violations) ADD_FAILURE() << violation;
        EXPECT_EQ(record.sessions, 0);
        EXPECT_EQ(record.swapchains, 0);
        EXPECT_EQ(record.spaces, 0);
        EXPECT_EQ(record.actionSets, 0);
        EXPECT_EQ(record.handTrackers, 0);
        opened_.reset();
        runtime_.reset();
        EXPECT_EQ(xr_script::record().instances, 0);
    }

    RoomScene scene() const {
        RoomScene made;
        made.volume = scenes::volumeOf(
            kVoxels, scenes::grid(glm::dvec3(1.0), kVoxels), [this](int i, int j, int k) -> std::uint16_t {
                const double outside = glm::length(glm::dvec3(i, j, k) - markerVoxel_) - kMarkerMm;
                return static_cast<std::uint16_t>(1000.0 * std::clamp(0.5 - outside, 0.0, 1.0));
            });
        made.drawing.transferFunction =
            std::make_shared<const TransferFunction>(scenes::ramp(400, 600, 0.99, 1.0));
        trace::LightRig white;
        white.name = "white";
        white.ambientZenith = white.ambientHorizon = white.ambientNadir = glm::dvec3(1.0);
        made.drawing.lights = std::make_shared<const trace::LightRig>(white);
        return made;
    }
    glm::dvec3 markerMm() const {
        return transformPoint(scenes::grid(glm::dvec3(1.0), kVoxels), markerVoxel_);
    }

    // Small pictures, so that it learns in a second.
    static hybrid::LiveModelOptions quickModel() {
        hybrid::LiveModelOptions o;
        o.model.firstSteps = 120;
        o.model.roundSteps = 60;
        o.model.settlingSteps = 20;
        o.model.firstCapacity = 300;
        o.model.mostSplats = 300;
        o.model.trend = {.leastFallPerSecond = 0.01, .window = 5, .leastSeconds = 0.02};
        o.model.wanted.sizePx = glm::ivec2(48);
        o.points = {.count = 250, .paths = 32};
        o.samplesPerPixel = 4;
        o.views = 10;
        o.stepsBetweenViews = 4;
        return o;
    }

    void connect(xr_script::Script script) {
        xr_script::follow(std::move(script));
        runtime_ = expectOk(Runtime::connect());
        expectOk(runtime_->findHeadset());
        opened_.emplace(expectOk(openDevice(*runtime_, gpu::validationOfTests())));
    }
    void show(const RoomOptions& options = {.model = {}, .learns = false}) {
        view_.emplace(expectOk(RoomView::create(opened_->device, scene(),
                                                std::make_shared<hybrid::ModelShelf>(std::uint64_t(1) << 20),
                                                options)));
        open();
    }
    void open(std::optional<glm::dmat4> placed = {}, std::shared_ptr<RoomControls> controls = nullptr) {
        headset_.reset();
        headset_.emplace(expectOk(
            Headset::open(runtime_, opened_->device, *view_, placed, options_, std::move(controls))));
    }
    // Frames until so many were submitted.
    void frames(std::uint64_t count) {
        const std::uint64_t wanted = xr_script::record().ended + count;
        for (std::uint64_t i = 0; i < 4 * count + 20 && xr_script::record().ended < wanted; ++i)
            ASSERT_NE(expectOk(headset_->step()), Headset::Step::ended);
        ASSERT_EQ(xr_script::record().ended, wanted);
    }
    // The fovea is all of what `eyes` see, as fine as that, without noise that matters.
    void traceAll(const EyePictures& eyes, std::uint32_t samples) {
        const double half = std::tan(0.5 * glm::radians(eyes.centre.verticalFovDeg)) *
                            std::max(1.0, double(eyes.sizePx.x) / eyes.sizePx.y);
        expectOk(view_->frame().aim(
            {.whole = {.camera = eyes.centre, .width = eyes.sizePx.x, .height = eyes.sizePx.y},
             .fieldDeg = glm::degrees(2.0 * std::atan(half)),
             .sidePx = std::max(eyes.sizePx.x, eyes.sizePx.y),
             .samplesPerPixel = samples}));
        for (int i = 0; i < 10000 && view_->frame().isTracing(); ++i)
            static_cast<void>(expectOk(view_->frame().traceFovea([] { return true; })));
        ASSERT_FALSE(view_->frame().isTracing());
    }
    static xr_script::SubmittedFrame lastFrame() { return xr_script::record().frames.back(); }

    std::shared_ptr<Runtime> runtime_;
    std::optional<HeadsetDevice> opened_;
    std::optional<RoomView> view_;
    HeadsetOptions options_{.holdsRate = false};  // a machine that is busy changes no picture
    std::optional<Headset> headset_;
};

}  // namespace macula::xr
