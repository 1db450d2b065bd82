// What was shown, as JSON: for recordings and measurements.
#pragma once

#include <nlohmann/json.hpp>

#include "live/frame/render_events.h"

namespace macula::app {

// "picture" is nameOf(OnScreen), "tracedShare" the share of its
// pixels that are traced, "fidelity" is "final" when nothing will change any more, else "preliminary";
// "because" says what is between the frame and a picture that was traced from here with all its samples.
// Times in ms. No patient data.
nlohmann::ordered_json toJson(const FrameShown& frame);

}  // namespace macula::app
