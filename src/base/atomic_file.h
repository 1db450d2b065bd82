// Files that are either written whole or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "base/result.h"

namespace macula {

// Calls write(temporaryPath) and puts what it wrote, a file that is there already, in place of `path` when it
// succeeds (see draft.h); removes it when it does not, and `path` is as it was. The temporary lies in the
// same folder and has the same extension.
Result<void> writeAtomically(const std::filesystem::path& path,
                             const std::function<Result<void>(const std::filesystem::path&)>& write);

Result<void> writeTextAtomically(const std::filesystem::path& path, std::string_view text);

// The whole file. Fails with inputNotUsable when it is missing, no regular file, or larger than maxBytes.
Result<std::string> readText(const std::filesystem::path& path, std::size_t maxBytes = 16u << 20);

}  // namespace macula
