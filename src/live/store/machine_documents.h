// Small documents in the study store about this machine and its user, for all studies. Each call opens the
// store and waits for the disk, so call from a thread that may block. Any number of stores and processes may
// have the folder open meanwhile.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "session/store.h"

namespace macula::live {

// Nothing if there is none. `id` names no study. Fails as session::Store.
Result<std::optional<std::string>> machineDocument(const std::filesystem::path& folder,
                                                   const session::DocumentId& id);

// Replaces the document of that name with `json`, an object. Fails likewise.
Result<void> keepMachineDocument(const std::filesystem::path& folder, const session::DocumentId& id,
                                 std::int64_t version, std::string_view json);

}  // namespace macula::live
