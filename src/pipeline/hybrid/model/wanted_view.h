// The views that a model asks for and learns from, one after another, each in slices.
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

// Used by one thread at a time, the one that uses the device. The tracer and the model are the same until
// it is made anew, and nobody else sets views of that tracer meanwhile.
class WantedView {
  public:
    // Of a model that goes on after so many steps with views that it was given, or asked for in vain.
    void resume(std::size_t views, std::uint64_t steps);

    // It is time for the next one: at least so many steps after the last, and so many more that training
    // takes as long as tracing does.
    bool isDue(const PeripheralModel& model, const LiveModelOptions& options) const;
    Result<void> ask(PeripheralModel& model, trace::PathTracer& tracer, const trace::Settings& settings,
                     const LiveModelOptions& options);
    bool isAsked() const { return wanted_.has_value(); }

    // When it is asked; the next call goes on where `goesOn` said no.
    Result<void> trace(trace::PathTracer& tracer, std::uint32_t samplesPerPixel,
                       const std::function<bool()>& goesOn);
    bool isTraced() const { return isTraced_; }
    Result<void> take(PeripheralModel& model, trace::PathTracer& tracer);  // when it is traced

    // How long these took.
    void tookToTrain(double ms) { trainedMs_ += ms; }
    void tookToTrace(double ms) { lastViewMs_ += ms; }

  private:
    std::optional<Camera> wanted_;  // the view that is traced now
    bool isTraced_ = false;         // and is to be taken
    std::size_t views_ = 0;         // that the model was given, or asked for in vain
    std::uint64_t stepsAtLastView_ = 0;
    double lastViewMs_ = 0.0;  // that tracing took
    double trainedMs_ = 0.0;   // since that
};

}  // namespace macula::hybrid
