// How close a displayed frame is to a complete traced picture, in words and as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
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

// A displayed frame as JSON, for recordings and measurements. "picture" is nameOf(OnScreen), "tracedShare"
// the share of traced pixels. "fidelity" is "final" or "preliminary", and "because" gives the reasons. Times
// in ms. No patient data.
nlohmann::ordered_json toJson(const FrameShown& frame);

}  // namespace macula::live
