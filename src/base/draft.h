// A draft: an unfinished file or folder under a hidden name, in the same folder as its target.
#pragma once

#include <filesystem>

#include "base/result.h"

namespace macula {

// A file or folder under a hidden, unique name that nobody can guess: ".NAME.<16 hex>.part.EXT". It keeps the
// target's extension, because writers choose the format by it. Its maker keeps it locked; an unlocked draft
// was left by a program that was killed.
class Draft {
  public:
    enum class Kind { file, folder };

    // Fails with outputNotWritable, for instance where the folder of the target does not exist.
    static Result<Draft> beside(const std::filesystem::path& target, Kind kind);
    // Turns a folder that is there into a draft: at once nothing stands at its place, and its files go with
    // the draft. Fails with outputNotWritable, and then all of it stays.
    static Result<Draft> of(const std::filesystem::path& folder);

    Draft(Draft&& other) noexcept;
    Draft& operator=(Draft&&) = delete;
    ~Draft();  // removes the draft, unless it was moved to its target

    const std::filesystem::path& path() const { return path_; }

  private:
    Draft(std::filesystem::path path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}

    std::filesystem::path path_;
    int descriptor_ = -1;
};

// Moves a written file to its target. Replaces only a regular file, whose permissions it takes over. Writes
// the data to the disk before the rename: when the disk is full or broken, this fails and the old file stays.
Result<void> putInPlace(const std::filesystem::path& written, const std::filesystem::path& target);

// Removes the drafts that killed programs left in the folder.
void removeAbandonedDrafts(const std::filesystem::path& folder);

}  // namespace macula
