// From what the user typed after --lights to an environment.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "pipeline/trace/environment.h"
#include "pipeline/trace/look.h"

namespace macula::app {

inline constexpr const char* kDefaultLights = "studio";
// The name of the rig for a look that nobody chose lights for: soft light from everywhere shows shape by
// shadow alone, and nothing glares, which is the clear look.
std::string_view defaultLightsFor(trace::Look look);

// All built-in rigs, by name.
Result<std::vector<trace::LightRig>> builtInLights();

// A built-in name, a JSON light rig, or an equirectangular HDR or EXR picture. usage when it is none of
// these; inputNotUsable when the file is malformed or its light is not: NaN, infinite or negative values.
Result<trace::Environment> chooseLights(const std::string& nameOrFile);

// As chooseLights, for what can be told as numbers; usage for a picture.
Result<trace::LightRig> chooseLightRig(const std::string& nameOrFile);

// What may be told of the choice, as publicPresetName.
std::string publicLightsName(const std::string& nameOrFile);
std::string publicLightsName(const trace::LightRig& rig);

// As chooseLights, for what holds light that stays where it is, as a peripheral model does: usage also for
// lights that hang on the camera.
Result<trace::Environment> choosePatientLights(const std::string& nameOrFile);
Result<void> checkPatientLights(const trace::Environment& lights, const std::string& name);

}  // namespace macula::app
