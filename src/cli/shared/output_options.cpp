#include "cli/shared/output_options.h"

#include <fmt/format.h>

#include <CLI/App.hpp>

#include "base/atomic_file.h"

namespace macula::cli {

void addOverwrite(CLI::App& command, bool& overwrite) {
    command.add_flag("--overwrite", overwrite, "Replace what is there already; never what is read");
    command.add_flag("--force", overwrite)->group("");
}

Result<void> printOrWrite(const std::filesystem::path& path, std::string_view text) {
    if (path != "-") return writeTextAtomically(path, fmt::format("{}\n", text));
    fmt::print("{}\n", text);
    return {};
}

}  // namespace macula::cli
