// How large and how fine a picture for the fovea the available time allows. kFovealFieldDeg of
// trace/settings.h is the most.
#pragma once

#include <cstdint>
#include <optional>

#include "pipeline/gpu/device.h"
#include "pipeline/hybrid/frame/hybrid_frame.h"

namespace macula::hybrid {

// Tracing time of a picture while the view moves. A hand turns a view by a few degrees in that time.
inline constexpr double kFoveaBudgetMs = 250.0;
// Tracing time of each fovea after the first at rest, if a picture of all pixels takes longer.
inline constexpr double kRestFoveaBudgetMs = 2000.0;
// With less time a fovea is too small to be worth the frames that it delays.
inline constexpr double kLeastFoveaBudgetMs = 60.0;

// Time per pixel and sample, until there is a measurement (HybridFrame::foveaMsPerSample).
double guessedFoveaMsPerSample(const gpu::Device& device);

// The fovea that is wanted if there is time for it.
struct FoveaOptions {
    double fieldDeg = trace::kFovealFieldDeg;
    std::uint32_t samplesPerPixel = 1;
    trace::Denoising denoising = trace::Denoising::on;

    bool operator==(const FoveaOptions&) const = default;
};

// With enough time the fovea has the wanted field and the frame's resolution. With less, first the field
// shrinks to three fifths, then the resolution falls to half, then the field shrinks on to a tenth, in steps
// of a twentieth of the sides. It is never larger than the frame. `whole` must be a usable view, and
// milliseconds must be above 0.
FoveaAim affordableFovea(const trace::View& whole, const glm::dvec2& gaze, double msPerSample,
                         double budgetMs = kFoveaBudgetMs, const FoveaOptions& request = {});

}  // namespace macula::hybrid
