// Converts Apple's property lists from XML to JSON, so that JSON readers can read them.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "base/result.h"

namespace macula::presets {

// dict, array, string, date and data (both as text), real, integer, true, false. Fails with inputNotUsable
// for text that is not a property list, and for the binary form.
Result<nlohmann::json> jsonFromPropertyList(std::string_view text, const std::string& where);

}  // namespace macula::presets
