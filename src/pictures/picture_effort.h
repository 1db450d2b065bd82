// How much work goes into a picture.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/result.h"
#include "pipeline/trace/settings.h"

namespace macula::app {

inline constexpr std::uint32_t kMostSamplesPerPixel = 1 << 20;

// What a person asked for: what is given itself counts more than the quality.
struct EffortWish {
    std::string quality;  // by name or file; empty: not given
    std::optional<std::uint32_t> samplesPerPixel;
    double error = 0.0;  // the most noise, as displayed, black to white being 1; 0: not given
    std::optional<int> bounces;
    std::optional<bool> denoise;
    std::optional<trace::Filter> filter;
};

struct Effort {
    std::uint32_t samplesPerPixel = 64;  // with Settings::errorThreshold the most of them
    trace::Settings settings;
};

// `settings` with bounces, filter, denoising and threshold as wished; without a wish 64 samples, or 8 where
// the look has no chance in it. Fails as chooseQuality.
Result<Effort> effortOf(const EffortWish& wish, const trace::Settings& settings);

}  // namespace macula::app
