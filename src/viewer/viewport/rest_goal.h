// When the picture at rest is final.
#pragma once

#include <cstdint>

#include "live/frame/frame_input.h"

namespace macula::viewer {

// When a picture counts as converged, and whether training of the model waits for that.
struct RestGoal {
    std::uint32_t sampleLimit = 512;
    double noiseTarget = live::kUnseenNoise;
    bool convergesNow = false;

    bool operator==(const RestGoal&) const = default;
};

}  // namespace macula::viewer
