// Where models are kept between runs: options that several verbs have.
#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <optional>

namespace macula::cli {

// --sessions and --no-session. `sessions` is the folder, nothing where none is to be kept.
void addStoreOptions(CLI::App& command, std::optional<std::filesystem::path>& sessions);

}  // namespace macula::cli
