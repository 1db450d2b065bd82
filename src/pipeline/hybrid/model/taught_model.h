// The model of the present scene after its start: taught in slices, and drawn.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/hybrid/frame/brightness_gauge.h"
#include "pipeline/hybrid/model/drawn_model.h"
#include "pipeline/hybrid/model/learning_pace.h"
#include "pipeline/hybrid/model/live_model_options.h"
#include "pipeline/hybrid/model/model_store.h"
#include "pipeline/hybrid/model/peripheral_model.h"
#include "pipeline/hybrid/model/wanted_view.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::hybrid {

// Used by one thread at a time, the one that uses the device.
class TaughtModel {
  public:
    TaughtModel(std::shared_ptr<gpu::Device> device, const LiveModelOptions& options)
        : device_(std::move(device)), options_(options) {}

    bool exists() const { return model_.has_value(); }
    // Only if it exists.
    PeripheralModel& model() { return *model_; }
    const PeripheralModel& model() const { return *model_; }

    // A stored model may be drawn before exists().
    DrawnModel& drawn() { return drawn_; }
    const DrawnModel& drawn() const { return drawn_; }
    Result<void> showStored(const StoredModel& stored) {
        return drawn_.show(device_, stored.splats, stored.gain);
    }
    // As LiveModel::draw. May draw older splats: learnSome makes new ones drawable, so that no frame waits.
    Result<const splat::DevicePicture*> draw(const Camera& camera, const glm::ivec2& sizePx, double nearMm);

    Result<void> resume(const PeripheralState& state);
    // Traces the gauge of that box, in slices. Returns true once it is whole and `goesOn` says yes. Then call
    // begin(): a model learns from the pictures of the gauge first.
    Result<bool> traceGauge(const Box& seenMm, trace::PathTracer& tracer, const trace::Settings& settings,
                            const std::function<bool()>& goesOn);
    Result<void> begin(const ModelStart& start);
    // Trains the model up to `steps` steps, and then makes it drawable. Returns whether that is done.
    Result<bool> takeFirstSteps(std::uint64_t steps, double budgetMs, const std::function<bool()>& goesOn);
    void forget();  // all but the pace of the device

    // A slice of learning, only if it exists: part of a view that `tracer` traces with these settings, or
    // training. Returns `all` when its views can teach it no more.
    enum class Learnt { something, trained, all };
    Result<Learnt> learnSome(trace::PathTracer& tracer, const trace::Settings& settings,
                             const std::function<bool()>& goesOn);
    // Only parts that are expected to fit into `leftMs`.
    Result<void> learnWithin(double leftMs, trace::PathTracer& tracer, const trace::Settings& settings,
                             const std::function<bool()>& keepGoing);
    void refuseStep();  // LearningPace::refusedStep
    // As LiveModel::learnFrom; returns whether it has learnt.
    Result<bool> learnFrom(trace::PathTracer& tracer, const trace::View& view, std::uint32_t samples);

  private:
    Result<void> makeDrawable();
    Result<void> doPart(LearningPart part, trace::PathTracer& tracer, const trace::Settings& settings,
                        const std::function<bool()>& goesOn);
    std::optional<LearningPart> nextWithin(double leftMs) const;
    bool wantsView() const { return wanted_.isDue(*model_, options_); }
    bool isShownDrawn() const { return drawn_.isOf(model_->shown().splats); }

    std::shared_ptr<gpu::Device> device_;
    LiveModelOptions options_;
    std::optional<BrightnessGauge> gauge_;  // traced again for a resumed model
    std::optional<PeripheralModel> model_;
    struct LookedAt {
        Camera camera;
        std::uint32_t samples = 0;  // of each pixel
    };
    std::optional<LookedAt> lookedAt_;  // the last picture on screen that the model learnt from
    WantedView wanted_;
    LearningPace pace_;
    DrawnModel drawn_;
};

}  // namespace macula::hybrid
