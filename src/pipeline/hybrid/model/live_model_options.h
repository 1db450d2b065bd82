// How a live model (live_model.h) is found and taught.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "pipeline/gpu/device.h"
#include "pipeline/hybrid/model/peripheral_model.h"
#include "pipeline/trace/surface_points.h"

namespace macula::hybrid {

struct LiveModelOptions {
    PeripheralOptions model;            // wanted.sizePx is the size of training views
    trace::SurfacePointOptions points;  // count: at most model.firstCapacity
    std::uint32_t samplesPerPixel = 2;  // of training views
    std::uint64_t roughSteps = 0;       // so many first training steps use
    int roughSidePx = 0;                // training views of this size
    std::size_t views = 48;             // most views that a model asks for
    // Training steps between two traced views: at least the first number, then until training has taken as
    // long as tracing the last view, but at most the second.
    std::uint64_t stepsBetweenViews = 8;
    std::uint64_t mostStepsBetweenViews = 24;
    std::uint64_t stepsBeforeShown = 40;               // training steps with the small pictures of the gauge
    std::chrono::milliseconds mostWaitForStore{2000};  // then a model begins without
    std::chrono::milliseconds leastBetweenKeeping{20000};
    std::optional<double> dispatchMs = {};  // of tracing; nothing: PathTracer's own
};
// Options that are fast enough on this device for learning while a picture converges.
LiveModelOptions liveModelOptions(const gpu::Device& device);

}  // namespace macula::hybrid
