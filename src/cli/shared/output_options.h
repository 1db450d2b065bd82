// Where the verbs write to.
#pragma once

#include <filesystem>
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

}  // namespace macula::cli
