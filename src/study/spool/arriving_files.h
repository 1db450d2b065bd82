// Files on their way into the spool: hidden, locked drafts beside the folders of its studies, so that a file
// gets its name by a rename once it is whole.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>

#include "base/draft.h"
#include "base/result.h"
#include "study/spool/spool_limits.h"

namespace macula::study {

Result<void> makePrivateFolder(const std::filesystem::path& folder);
Error spoolNotWritable(const std::filesystem::path& path);

// Thread-safe.
class ArrivingFiles {
  public:
    // Makes the folder if it is missing, and removes what killed programs left there.
    static Result<std::filesystem::path> prepareFolder(const std::filesystem::path& spool);

    ArrivingFiles(const std::filesystem::path& spool, const SpoolLimits& limits);

    // A new, empty file of mode 0600. Fails with outputNotWritable where the disk is full.
    Result<std::filesystem::path> place();
    // Whoever takes it removes it, or moves it to its name; nothing where it is none of these.
    std::optional<Draft> take(const std::filesystem::path& file);
    void drop(const std::filesystem::path& file) noexcept;

    std::size_t count() const;
    // Asked while files grow: several at once must not fill the disk.
    std::uintmax_t mostBytesOfFile() const;

  private:
    const std::filesystem::path folder_;
    const SpoolLimits limits_;
    mutable std::mutex mutex_;
    std::map<std::filesystem::path, Draft> drafts_;
};

}  // namespace macula::study
