// A draft: what is being written, under a hidden name beside its target, until it is whole.
#pragma once

#include <filesystem>

#include "base/result.h"

namespace macula {

// A file or folder under a hidden name that nobody can guess and nobody else has: ".NAME.<16 hex>.part.EXT",
// the extension of the target kept, because writers choose the format by it. It is locked while it is being
// made, so that what a killed program left can be told from what another one is writing.
class Draft {
  public:
    enum class Kind { file, folder };

    // Fails with outputNotWritable, for instance where the folder of the target does not exist.
    static Result<Draft> beside(const std::filesystem::path& target, Kind kind);

    Draft(Draft&& other) noexcept;
    Draft& operator=(Draft&&) = delete;
    ~Draft();  // removes what was not moved away

    const std::filesystem::path& path() const { return path_; }

  private:
    Draft(std::filesystem::path path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}

    std::filesystem::path path_;
    int descriptor_ = -1;
};

// Moves a written file to where it belongs, in place of the one that stands there, whose permissions it gets.
// What it holds is on the disk before it has the name: a full or broken disk is told here, and leaves what
// was there. Only a regular file is replaced.
Result<void> putInPlace(const std::filesystem::path& written, const std::filesystem::path& target);

// Removes the drafts in that folder whose makers were killed.
void removeAbandonedDrafts(const std::filesystem::path& folder);

}  // namespace macula
