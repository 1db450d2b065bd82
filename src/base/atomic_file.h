// Files that are either written whole or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "base/result.h"

namespace macula {

// Calls write(temporaryPath). If it succeeds, puts the temporary file, which exists before the call, in place
// of `path` (see draft.h); otherwise removes it and leaves `path` as it was. The temporary lies in the same
// folder and has the same extension.
Result<void> writeAtomically(const std::filesystem::path& path,
                             const std::function<Result<void>(const std::filesystem::path&)>& write);

Result<void> writeTextAtomically(const std::filesystem::path& path, std::string_view text);

// The whole file. Fails with inputNotUsable when it is missing, no regular file, or larger than maxBytes.
Result<std::string> readText(const std::filesystem::path& path, std::size_t maxBytes = 16u << 20);

}  // namespace macula
