// Edits of a light rig by hand. Each function takes the current rig and returns the next one, which a file
// can hold (light_rig_json.h): numbers are clamped to its limits, and a rig that would be black is refused
// with usage. Name and title become those of an own rig.
#pragma once

#include <cstddef>

#include "base/result.h"
#include "pipeline/trace/environment.h"
#include "scene/lights/light_direction.h"

namespace macula::scene {

inline constexpr const char* kOwnLightsName = "own";
inline constexpr const char* kOwnLightsTitle = "Own";

// Replaces the light at `index`; usage if there is none.
Result<trace::LightRig> withLight(trace::LightRig rig, std::size_t index, const trace::SoftLight& light);
// Appends the light; usage if a file has no room for one more.
Result<trace::LightRig> withLightAdded(trace::LightRig rig, const trace::SoftLight& light);
Result<trace::LightRig> withoutLight(trace::LightRig rig, std::size_t index);
// Scales the sky to this mean brightness over all directions (skyOf), in its own colours; a black sky becomes
// grey.
Result<trace::LightRig> withSky(trace::LightRig rig, double radiance);
double skyOf(const trace::LightRig& rig);
// Fixes the lights to the patient or to the camera without moving them in the world. The sky turns with them.
Result<trace::LightRig> keptTo(trace::LightRig rig, trace::LightFrame frame, const LightStand& stand);

}  // namespace macula::scene
