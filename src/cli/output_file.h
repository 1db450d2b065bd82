// The picture file that a render ends in.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "base/result.h"
#include "image/image_file.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::cli {

// Fails now, not after minutes of tracing: usage for an extension that is neither .png nor .exr,
// outputNotWritable when nothing can be written there.
Result<void> checkOutput(const std::filesystem::path& path);

// Fails with outputNotWritable when the folder that `path` lies in does not exist or nothing can be written
// there, or when `path` is a folder itself.
Result<void> checkPlaceOf(const std::filesystem::path& path);

bool isExr(const std::filesystem::path& path);

}  // namespace macula::cli
