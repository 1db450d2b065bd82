// Converts what the user typed after --lights to an environment.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "pipeline/trace/environment.h"
#include "pipeline/trace/look.h"

namespace macula::scene {

inline constexpr const char* kDefaultLights = "studio";
// The name of the default rig of a look. The clear look gets soft light from everywhere, which shows shape by
// shadow alone, without glare.
std::string_view defaultLightsFor(trace::Look look);

// All built-in rigs, by name.
Result<std::vector<trace::LightRig>> builtInLights();

// A built-in name, a JSON light rig, or an equirectangular HDR or EXR picture. usage when it is none of
// these; inputNotUsable when the file is malformed or holds NaN, infinite or negative light.
Result<trace::Environment> chooseLights(const std::string& nameOrFile);

// As chooseLights, but for a light rig only: usage for a picture.
Result<trace::LightRig> chooseLightRig(const std::string& nameOrFile);

// The name to show in a picture or a report, as publicPresetName.
std::string publicLightsName(const std::string& nameOrFile);
std::string publicLightsName(const trace::LightRig& rig);

// As chooseLights, but only for lights fixed to the patient, as a peripheral model needs: usage also for
// lights that hang on the camera.
Result<trace::Environment> choosePatientLights(const std::string& nameOrFile);
Result<void> checkPatientLights(const trace::Environment& lights, const std::string& name);

}  // namespace macula::scene
