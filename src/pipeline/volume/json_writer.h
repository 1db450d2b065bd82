// Writes JSON as people would: short lists and objects on one line, and numbers as the shortest text that
// reads back as the same double.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace macula {

// Indents by 4, and ends with a line break. Replaces what is not UTF-8. Breaks objects and lists that contain
// objects or are long into lines, and no others. Reading and writing such a text gives the same text.
std::string prettyJson(const nlohmann::ordered_json& value);

}  // namespace macula
