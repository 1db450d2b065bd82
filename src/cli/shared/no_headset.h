// What commands about headsets are in a build without OpenXR.
#pragma once

#include <CLI/App.hpp>
#include <string>

#include "cli/shared/program.h"

namespace macula::cli {

// Takes whatever is given besides, and answers that this build knows no headsets.
inline void addWithoutHeadset(CLI::App& app, Action& action, const std::string& what) {
    auto* command = app.add_subcommand("xr", what + " (this build cannot)");
    command->allow_extras();
    command->callback([&action] {
        action = []() -> Result<void> {
            return Error{ErrorCode::deviceNotUsable, Text("This build of Macula knows no headsets."), "",
                         Text("Build it with the package libopenxr-dev installed.")};
        };
    });
}

}  // namespace macula::cli
