// A light rig that is changed by hand. Each function takes the rig that is seen and gives the one to be seen
// next, which a file can hold (light_rig_json.h): numbers beyond what it can are its ends, and a rig that
// would be black is refused with usage. Name and title become those of an own rig.
#pragma once

#include <cstddef>

#include "base/result.h"
#include "pipeline/trace/environment.h"
#include "scene/lights/light_direction.h"

namespace macula::app {

inline constexpr const char* kOwnLightsName = "own";
inline constexpr const char* kOwnLightsTitle = "Own";

// `light` takes the place of that light; usage where there is none.
Result<trace::LightRig> withLight(trace::LightRig rig, std::size_t index, const trace::SoftLight& light);
// As the last one; usage where a file has no room for one more.
Result<trace::LightRig> withLightAdded(trace::LightRig rig, const trace::SoftLight& light);
Result<trace::LightRig> withoutLight(trace::LightRig rig, std::size_t index);
// Its sky is as bright as that on average over all directions, in the colours that it had; grey of a black
// one.
Result<trace::LightRig> withSky(trace::LightRig rig, double radiance);
double skyOf(const trace::LightRig& rig);
// Its lights keep to the patient, or to the camera, and shine from where they shone. Its sky turns along.
Result<trace::LightRig> keptTo(trace::LightRig rig, trace::LightFrame frame, const LightStand& stand);

}  // namespace macula::app
