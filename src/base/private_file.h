// Files and folders that only their owner can read.
#pragma once

#include <filesystem>
#include <string_view>

#include "base/result.h"

namespace macula {

// Makes the folder and those above it that are missing; the folder itself gets mode 0700, also if it was
// there. Fails with outputNotWritable.
Result<void> makePrivateFolder(const std::filesystem::path& folder);

// Writes the file whole or not at all, with mode 0600 from its first byte on. Its folder must be there. Fails
// with outputNotWritable.
Result<void> writeTextPrivately(const std::filesystem::path& file, std::string_view text);

}  // namespace macula
