// How large and how fine a picture for the fovea is, for the time that there is for it.
#pragma once

#include <cstdint>
#include <optional>

#include "pipeline/gpu/device.h"
#include "pipeline/hybrid/frame/hybrid_frame.h"

namespace macula::hybrid {

// Tracing time of a picture while the view moves: a hand turns a view by some degrees in it.
inline constexpr double kFoveaBudgetMs = 250.0;
// Of each fovea after the first at rest, where a picture of all pixels takes longer than that.
inline constexpr double kRestFoveaBudgetMs = 2000.0;
// With less time than that it is too small to be worth the frames that come later for it.
inline constexpr double kLeastFoveaBudgetMs = 60.0;

// Time per pixel and sample before it was measured (HybridFrame::foveaMsPerSample).
double guessedFoveaMsPerSample(const gpu::Device& device);

// What is wanted of one, where time allows.
struct FoveaOptions {
    double fieldDeg = trace::kFovealFieldDeg;
    std::uint32_t samplesPerPixel = 1;
    trace::Denoising denoising = trace::Denoising::on;

    bool operator==(const FoveaOptions&) const = default;
};

// With enough time the wanted field, and as fine as the frame. With less, first the
// field shrinks to three fifths, then the resolution falls to half, then the field shrinks on, to a tenth at
// last, in steps of a twentieth of the sides. Never larger than the frame. `whole` is a usable view;
// milliseconds are above 0.
FoveaAim affordableFovea(const trace::View& whole, const glm::dvec2& gaze, double msPerSample,
                         double budgetMs = kFoveaBudgetMs, const FoveaOptions& request = {});

}  // namespace macula::hybrid
