// What is kept of the machine and of whoever sits at it, for all studies: small documents of the store of
// sessions. Each call opens the store, and waits for the disk: for a thread that nobody waits for. Any number
// of stores may have the folder open meanwhile, and so may other processes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "session/store.h"

namespace macula::app {

// Nothing where there is none. `id` is of no study. Fails as session::Store.
Result<std::optional<std::string>> machineDocument(const std::filesystem::path& folder,
                                                   const session::DocumentId& id);

// `json` is an object; it takes the place of all that was kept under that name. Fails likewise.
Result<void> keepMachineDocument(const std::filesystem::path& folder, const session::DocumentId& id,
                                 std::int64_t version, std::string_view json);

}  // namespace macula::app
