// Files that are either written whole or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "base/result.h"

namespace macula {

// Calls write(temporaryPath) and renames the temporary to `path` when it succeeds; removes it when it does
// not. The temporary lies in the same folder and has the same extension (image writers choose the format by
// it).
Result<void> writeAtomically(const std::filesystem::path& path,
                             const std::function<Result<void>(const std::filesystem::path&)>& write);

Result<void> writeTextAtomically(const std::filesystem::path& path, std::string_view text);

// The whole file. Fails with inputNotUsable when it is missing, no regular file, or larger than maxBytes.
Result<std::string> readText(const std::filesystem::path& path, std::size_t maxBytes = 16u << 20);

}  // namespace macula
