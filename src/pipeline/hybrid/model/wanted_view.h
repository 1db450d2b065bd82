// Traces the views that a model asks for, one after another, each in slices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include "base/camera.h"
#include "base/result.h"
#include "pipeline/hybrid/model/live_model_options.h"
#include "pipeline/hybrid/model/peripheral_model.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::hybrid {

// Used by one thread at a time, the one that uses the device. All calls must name the same tracer and model,
// and nobody else may set views of that tracer meanwhile.
class WantedView {
  public:
    // For a resumed model after `steps` steps, with `views` that it was given, or asked for in vain.
    void resume(std::size_t views, std::uint64_t steps);

    // Whether it is time for the next view: at least stepsBetweenViews after the last, and once training has
    // taken as long as tracing did, or after mostStepsBetweenViews (LiveModelOptions).
    bool isDue(const PeripheralModel& model, const LiveModelOptions& options) const;
    Result<void> ask(PeripheralModel& model, trace::PathTracer& tracer, const trace::Settings& settings,
                     const LiveModelOptions& options);
    bool isAsked() const { return wanted_.has_value(); }

    // Only if isAsked(); the next call continues where `goesOn` said no.
    Result<void> trace(trace::PathTracer& tracer, std::uint32_t samplesPerPixel,
                       const std::function<bool()>& goesOn);
    bool isTraced() const { return isTraced_; }
    Result<void> take(PeripheralModel& model, trace::PathTracer& tracer);  // only if isTraced()

    // Note how long training, and the tracing of the present view, took.
    void tookToTrain(double ms) { trainedMs_ += ms; }
    void tookToTrace(double ms) { lastViewMs_ += ms; }

  private:
    std::optional<Camera> wanted_;  // the view that is traced now
    bool isTraced_ = false;         // and waits for take()
    std::size_t views_ = 0;         // given to the model, or asked for in vain
    std::uint64_t stepsAtLastView_ = 0;
    double lastViewMs_ = 0.0;  // tracing time of the last view
    double trainedMs_ = 0.0;   // training time since the last view
};

}  // namespace macula::hybrid
