// A displayed frame as JSON, for recordings and measurements.
#pragma once

#include <nlohmann/json.hpp>

#include "live/frame/render_events.h"

namespace macula::live {

// "picture" is nameOf(OnScreen), "tracedShare" the share of traced pixels. "fidelity" is "final" or
// "preliminary", and "because" gives the reasons (fidelity.h). Times in ms. No patient data.
nlohmann::ordered_json toJson(const FrameShown& frame);

}  // namespace macula::live
