// Which files go to an archive, and whose they are.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "study/open/identity.h"

namespace macula::study {

struct FilesToSend {
    std::vector<std::filesystem::path> files;
    std::vector<Identity> patients;  // each once
};

// All DICOM objects in these files and folders. Fails with inputNotUsable where a path holds none, or one
// that cannot be read.
Result<FilesToSend> filesToSend(std::span<const std::filesystem::path> paths, Progress& progress);

}  // namespace macula::study
