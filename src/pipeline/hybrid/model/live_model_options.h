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
    PeripheralOptions model;            // wanted.sizePx: of the pictures that it learns from
    trace::SurfacePointOptions points;  // count: at most model.firstCapacity
    std::uint32_t samplesPerPixel = 2;  // of these pictures
    std::uint64_t roughSteps = 0;       // first steps of training, which take
    int roughSidePx = 0;                // pictures of such sides
    std::size_t views = 48;             // pictures in all
    // Of training: at least so many, and so many more that training takes as long as tracing does.
    std::uint64_t stepsBetweenViews = 8;
    std::uint64_t mostStepsBetweenViews = 24;
    std::uint64_t stepsBeforeShown = 40;               // of training, on the small pictures of the gauge
    std::chrono::milliseconds mostWaitForStore{2000};  // then it begins without
    std::chrono::milliseconds leastBetweenKeeping{20000};
    std::optional<double> dispatchMs = {};  // of tracing its views; nothing: as PathTracer has it
};
// What is fast enough on the device to be taught beside a picture that converges.
LiveModelOptions liveModelOptions(const gpu::Device& device);

}  // namespace macula::hybrid
