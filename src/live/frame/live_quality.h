// How frames in motion are made: the traced fovea over the model.
#pragma once

#include <cstdint>

#include "pipeline/hybrid/frame/fovea_size.h"

namespace macula::live {

// Affects the noise and sharpness of a frame, never the simulated light.
struct LiveQuality {
    bool hasFovea = true;  // false: no new fovea is traced; an earlier traced picture is reused
    hybrid::FoveaOptions fovea{};
    double foveaMs = hybrid::kFoveaBudgetMs;  // tracing time of a fovea; less makes it smaller or coarser
    double betweenFramesMs = 12.0;            // the part of foveaMs between two frames

    bool operator==(const LiveQuality&) const = default;
};

}  // namespace macula::live
