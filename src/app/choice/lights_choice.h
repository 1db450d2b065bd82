// From what the user typed after --lights to an environment.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "pipeline/trace/environment.h"

namespace macula::app {

inline constexpr const char* kDefaultLights = "studio";

// All built-in ones, by name.
Result<std::vector<trace::LightRig>> builtInLights();

// A built-in name, a JSON light rig, or an equirectangular HDR or EXR picture. usage when it is none of
// these; inputNotUsable when the file is malformed or its light is not: NaN, infinite or negative values.
Result<trace::Environment> chooseLights(const std::string& nameOrFile);

// As publicPresetName.
std::string publicLightsName(const std::string& nameOrFile);

// The same, for what holds light that stays where it is, as a peripheral model does: usage also for lights
// that hang on the camera.
Result<trace::Environment> choosePatientLights(const std::string& nameOrFile);

}  // namespace macula::app
