#include "cli/store_options.h"

#include <CLI/Option.hpp>

#include "session/store.h"

namespace macula::cli {

void addStoreOptions(CLI::App& command, std::optional<std::filesystem::path>& sessions) {
    sessions = session::defaultFolder();
    auto* folder =
        command
            .add_option_function<std::filesystem::path>(
                "--sessions", [&sessions](const std::filesystem::path& given) { sessions = given; },
                "Where models of earlier runs are, and this one's is kept")
            ->option_text("FOLDER");
    command
        .add_flag_callback(
            "--no-session", [&sessions] { sessions.reset(); }, "Keep nothing, and begin anew")
        ->excludes(folder);
}

}  // namespace macula::cli
