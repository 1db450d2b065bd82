// How close a displayed frame is to a complete traced picture.
#pragma once

#include <string>
#include <vector>

#include "base/text.h"
#include "live/frame/render_events.h"

namespace macula::live {

struct Fidelity {
    bool isFinal = false;  // the picture stays as it is until the input changes
    // Why this frame is not a complete traced picture: of this view, with all pixels and samples, not
    // denoised. Each entry is a phrase for the user. Empty for a complete picture.
    std::vector<Text> because = {};
};

Fidelity fidelityOf(const FrameShown& frame);

}  // namespace macula::live
