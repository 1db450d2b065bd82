// What the verbs write, and where to.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "base/result.h"

namespace CLI {
class App;
}

namespace macula::cli {

// --overwrite, and words of before that still work.
void addOverwrite(CLI::App& command, bool& overwrite);

// Text and a line break: to a file, whole or not at all; to stdout when the path is "-".
Result<void> printOrWrite(const std::filesystem::path& path, std::string_view text);

// JSON as the programs print it. Text in old files is not always what its character set says; a broken byte
// is no reason to print nothing.
inline std::string jsonText(const nlohmann::ordered_json& json) {
    return json.dump(4, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace macula::cli
