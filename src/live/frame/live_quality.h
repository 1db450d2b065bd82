// What frames in motion are made with, beside the model: the traced picture for the fovea.
#pragma once

#include <cstdint>

#include "pipeline/hybrid/frame/fovea_size.h"

namespace macula::app {

// Changes noise and sharpness of a frame, and never what light does in it.
struct LiveQuality {
    bool hasFovea = true;  // else frames are of splats, but for a traced picture that is there already
    hybrid::FoveaWish fovea{};
    double foveaMs = hybrid::kFoveaBudgetMs;  // the most tracing for one: with less it is smaller or coarser
    double betweenFramesMs = 12.0;            // of that, between two frames

    bool operator==(const LiveQuality&) const = default;
};

}  // namespace macula::app
