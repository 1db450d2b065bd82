// Files that are either written whole or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "base/result.h"

namespace macula {

// Calls write(temporaryPath) with the path of an empty temporary file in the folder of `path`, with the same
// extension. If `write` succeeds, moves that file to `path` (see draft.h); otherwise removes it and leaves
// `path` as it was.
Result<void> writeAtomically(const std::filesystem::path& path,
                             const std::function<Result<void>(const std::filesystem::path&)>& write);

Result<void> writeTextAtomically(const std::filesystem::path& path, std::string_view text);

// Returns the whole file. Fails with inputNotUsable when it is missing, not a regular file, or larger than
// maxBytes.
Result<std::string> readText(const std::filesystem::path& path, std::size_t maxBytes = 16u << 20);

}  // namespace macula
