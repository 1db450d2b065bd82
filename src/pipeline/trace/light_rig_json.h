// Light rigs as JSON; presets/schema/light-rig.schema.json is the reference.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "pipeline/trace/environment.h"

namespace macula::trace {

// Fails with inputNotUsable; the message tells the line or the key, the hint what was expected. `where` is
// the file, for the error.
Result<LightRig> lightRigFromJson(std::string_view text, const std::string& where);

// Reading it back gives an equal rig.
std::string toJson(const LightRig& rig);

}  // namespace macula::trace
