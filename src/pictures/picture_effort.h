// Samples and quality of a picture.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/result.h"
#include "pipeline/trace/settings.h"

namespace macula::pictures {

inline constexpr std::uint32_t kMostSamplesPerPixel = 1 << 20;

// The options of the user: a field that is given overrides the quality.
struct EffortRequest {
    std::string quality;  // by name or file; empty: not given
    std::optional<std::uint32_t> samplesPerPixel;
    double error = 0.0;  // the largest noise in display values, black to white being 1; 0: not given
    std::optional<int> bounces;
    std::optional<bool> denoise;
    std::optional<trace::Filter> filter;
};

struct Effort {
    std::uint32_t samplesPerPixel = 64;  // at most so many with Settings::errorThreshold
    trace::Settings settings;
};

// Applies the request to `settings`. The default is 64 samples, or 8 for looks that are not path traced; with
// an error, kMostSamplesPerPixel. Fails as chooseQuality.
Result<Effort> effortOf(const EffortRequest& request, const trace::Settings& settings);

}  // namespace macula::pictures
