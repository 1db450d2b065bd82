// JSON as people would write it: what fits on a line stays on one, and a number is the shortest text that
// reads back as the same double.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace macula {

// Indented by 4; ends with a line break. What is not UTF-8 is replaced. Objects that hold others and lists of
// objects are broken into lines, all else is not. Writing what was read from such a text gives that text.
std::string prettyJson(const nlohmann::ordered_json& value);

}  // namespace macula
