// The peripheral model beside the tracer: of a small ball, and of half of it.
#include <gtest/gtest.h>

#include "pipeline/hybrid/model/peripheral_model.h"
#include "pipeline/hybrid/views/drawn_views.h"
#include "pipeline/hybrid/views/traced_scene.h"
#include "pipeline/hybrid/views/view_tracing.h"
#include "pipeline/trace/device_scene.h"
#include "trace/extreme_scenes.h"
#include "trace/gpu_scene.h"

namespace macula::hybrid {
namespace {

constexpr glm::ivec3 kVoxels{24, 24, 24};
constexpr glm::ivec2 kSize{48, 48};

class PeripheralTraced : public trace::DeviceTest {
  protected:
    const std::shared_ptr<const Volume> volume_ =
        scenes::volumeOf(kVoxels, scenes::grid(glm::dvec3(1.0), kVoxels), scenes::blob(kVoxels, 1000));
    const TransferFunction function_ = scenes::ramp(100, 500, 0.6, 1.0);
    const trace::Environment lights_ = trace::Environment::constant(glm::vec3(1.0f));
    Progress progress_;

    ModelStart startOf(trace::PathTracer& tracer, const Clip& clip, const std::string& key) {
        const auto scene = TracedScene::create(volume_, function_, clip, lights_);
        EXPECT_TRUE(scene.ok());
        EXPECT_TRUE(tracer.scene().setClip(clip).ok());
        return startFromPoints(tracer, scene->seenMm(), key, {.count = 150, .paths = 32}, progress_).value();
    }
    TracedView traced(trace::PathTracer& tracer, const Camera& camera, std::uint32_t seed) {
        ViewTracing options{.sizePx = kSize, .samplesPerPixel = 16};
        options.settings.seed = seed;
        return traceViews(tracer, std::span(&camera, 1), options, progress_).value().views.front();
    }
    // What whoever owns it does.
    void lookAround(PeripheralModel& model, trace::PathTracer& tracer, std::uint32_t views) {
        for (std::uint32_t i = 0; i < views; ++i) {
            const auto wanted = model.wantedView();
            ASSERT_TRUE(wanted.ok() && *wanted);
            ASSERT_TRUE(model.offer(traced(tracer, (*wanted)->camera, i)).ok());
        }
        for (int i = 0; i < 8; ++i) {
            const std::uint64_t before = model.report().training.steps;
            const auto ten = [&] { return model.report().training.steps < before + 10; };
            ASSERT_TRUE(model.step(1e6, ten).ok());
        }
    }
    double differenceTo(const splat::Splats& model, const TracedView& view) {
        const auto drawn = drawViews(device(), model, std::span(&view.camera, 1), view.sizePx);
        double sum = 0.0;
        for (std::size_t i = 0; i < view.rgba.size(); ++i)
            sum += double(glm::length(drawn->pictures[0][i] - view.rgba[i]));
        return sum / double(view.rgba.size());
    }
};

TEST_F(PeripheralTraced, LearnsWhatTheTracerShowsAndThenWhatAClipLeaves) {
    trace::PathTracer tracer =
        trace::DeviceTest::tracer(volume_, function_, lights_, scenes::lookAt(*volume_), {});
    PeripheralOptions options;
    options.firstSteps = 100;
    options.wanted.sizePx = kSize;
    options.wanted.verticalFovDeg = 14.0;
    const ModelStart whole = startOf(tracer, {}, "whole");
    ASSERT_GT(whole.splats.size(), 100u);
    PeripheralModel model = std::move(PeripheralModel::begin(device(), whole, options)).value();
    lookAround(model, tracer, 9);
    const Camera front{.positionMm = whole.seenMm.centre() - glm::dvec3(0, 60, 0),
                       .targetMm = whole.seenMm.centre(),
                       .verticalFovDeg = 20.0};
    const TracedView ofWhole = traced(tracer, front, 99);
    const splat::Splats learnt = *model.shown().splats;
    EXPECT_GT(model.shown().generation, 1u);
    EXPECT_LT(differenceTo(learnt, ofWhole), 0.9 * differenceTo(whole.splats, ofWhole));
}

TEST_F(PeripheralTraced, NothingToBeSeenOrCancelledIsNoStart) {
    trace::PathTracer tracer =
        trace::DeviceTest::tracer(volume_, function_, lights_, scenes::lookAt(*volume_), {});
    const Box box{glm::dvec3(-12.0), glm::dvec3(12.0)};
    CancelToken stop;
    stop.cancel();
    Progress stopped({}, stop);
    EXPECT_EQ(startFromPoints(tracer, box, "", {.count = 50}, stopped).error().code, ErrorCode::cancelled);
    Clip nothing;
    nothing.planes.push_back({.normal = {0, 0, 1}, .offsetMm = 1000.0});
    ASSERT_TRUE(tracer.scene().setClip(nothing).ok());
    EXPECT_EQ(startFromPoints(tracer, box, "", {.count = 50}, progress_).error().code,
              ErrorCode::inputNotUsable);
}

}  // namespace
}  // namespace macula::hybrid
