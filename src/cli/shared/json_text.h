// JSON as the programs print it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace macula::cli {

// Text in old files is not always what its character set says; a broken byte is no reason to print nothing.
inline std::string jsonText(const nlohmann::ordered_json& json) {
    return json.dump(4, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace macula::cli
