// Light rigs as JSON; presets/schema/light-rig.schema.json is the reference.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/result.h"
#include "pipeline/trace/environment.h"

namespace macula::trace {

// The limits of a file. The sky has a texel every 0.7 degrees: the power of smaller lights would depend on
// where they stand.
inline constexpr double kLeastLightRadiusDeg = 3.0;
inline constexpr double kMostLightRadiusDeg = 180.0;
inline constexpr double kMostRadiance = 1e6;
inline constexpr std::size_t kMostLights = 64;

// Fails with inputNotUsable: the message names the line or the key, the hint says what was expected. `where`
// is the file, for the error.
Result<LightRig> lightRigFromJson(std::string_view text, const std::string& where);

// lightRigFromJson() reads an equal rig from it.
std::string toJson(const LightRig& rig);

}  // namespace macula::trace
