// A model that runs by itself, and what it learns from: pictures of a known one.
#pragma once

#include <algorithm>

#include "pipeline/hybrid/model/peripheral_model.h"
#include "splat/train/training_scene.h"
#include "splat/training_support.h"

namespace macula::hybrid {

class PeripheralTest : public splat::TrainingTest {
  protected:
    static constexpr glm::ivec2 kSize{45, 40};

    static Box box() { return {glm::dvec3(-55.0), glm::dvec3(55.0)}; }

    // Pauses within a second or so: this learns fast.
    static PeripheralOptions options() {
        PeripheralOptions o{.firstSteps = 150, .roundSteps = 100, .settlingSteps = 20, .firstCapacity = 60};
        o.mostSplats = 80;
        o.judgingShare = 0.2;
        o.trend = {.leastFallPerSecond = 0.01, .window = 5, .leastSeconds = 0.02};
        o.wanted.sizePx = kSize;
        o.seed = 7;
        return o;
    }
    static ModelStart start(const std::string& key = "one") {
        return {.splats = TrainingTest::start(), .seenMm = box(), .key = key};
    }
    static splat::Splats withDirections(splat::Splats splats) {
        splats.setShDegree(1);
        return splats;
    }
    static bool isComparedAsJudged(const PeripheralModel& model) {
        const splat::TrainingState now = model.lastGood().training;
        return std::all_of(now.options.stages.begin(), now.options.stages.end(),
                           [](const splat::TrainingStage& stage) {
                               return stage.measure == splat::LossMeasure::similar && stage.halvings == 0;
                           });
    }
    static PeripheralModel begun(const PeripheralOptions& o = options()) {
        return std::move(PeripheralModel::begin(device(), start(), o)).value();
    }

    static TracedView picture(const splat::Splats& of, const Camera& camera,
                              const glm::ivec2& sizePx = kSize) {
        TracedView view{.camera = camera, .sizePx = sizePx, .samplesPerPixel = 8.0};
        view.rgba = draw(of, splat::rasterView(camera, sizePx, of.originMm).value());
        return view;
    }
    static Camera cameraAt(double degrees, double heightMm = 0.0, double fovDeg = 14.0) {
        const double angle = glm::radians(degrees);
        return {.positionMm = {500 * std::sin(angle), -500 * std::cos(angle), heightMm},
                .verticalFovDeg = fovDeg};
    }
    static std::size_t giveWanted(PeripheralModel& model, const splat::Splats& of, int count) {
        std::size_t learnt = 0;
        for (int i = 0; i < count; ++i) {
            const auto wanted = model.wantedView().value();
            if (!wanted) ADD_FAILURE() << "nothing is wanted";
            if (wanted) learnt += *model.offer(picture(of, wanted->camera)) == Offered::learnt ? 1u : 0u;
        }
        return learnt;
    }
    static double psnrFrom(const splat::Splats& model, const splat::Splats& of, const Camera& camera) {
        const auto view = splat::rasterView(camera, kSize, glm::dvec3(0.0)).value();
        return psnr(draw(model, view), draw(of, view));
    }
    // The pictures are of a model without directions, whatever degree the one that learns has.
    static double psnrOf(const splat::Splats& model) {
        return psnr(draw(model, heldOut()), draw(truth(), heldOut()));
    }
    // As with any clock.
    static PeripheralOptions neverPaused() {
        PeripheralOptions o = options();
        o.trend.leastFallPerSecond = -1e9;
        return o;
    }
    static void learn(PeripheralModel& model, std::uint64_t steps) {
        const std::uint64_t last = model.report().training.steps + steps;
        while (model.report().training.steps < last)
            ASSERT_TRUE(model.step(1e6, [&] { return model.report().training.steps < last; }).ok());
        // What is due is compared as well.
        for (int i = 0; i < 8; ++i) ASSERT_TRUE(model.step(0.0).ok());
    }
    // Until it pauses; steps that were made.
    static std::uint64_t run(PeripheralModel& model) {
        for (int i = 0; i < 2000 && !model.isPaused(); ++i) EXPECT_TRUE(model.step(20.0).ok());
        EXPECT_TRUE(model.isPaused());
        return model.report().training.steps;
    }
};

}  // namespace macula::hybrid
