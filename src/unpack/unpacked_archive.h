// The private copy of an archive's files, which goes when nobody needs it any more.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <utility>

#include "base/draft.h"
#include "base/progress.h"
#include "base/result.h"
#include "unpack/budget.h"

namespace macula::unpack {

// What an archive held.
struct ArchiveFacts {
    std::size_t files = 0;      // unpacked
    std::size_t encrypted = 0;  // left out, as are:
    std::size_t damaged = 0;    // damaged, or packed in a way that is not understood
    std::size_t links = 0;      // symbolic links, and devices
    std::size_t outside = 0;    // unpacked, though their names lead out of the archive
    bool isCutOff = false;      // its end is missing or cannot be read
};

// A folder of mode 0700 with files of mode 0600. The destructor removes it; after a crash the next unpack(),
// of any program, or removeAbandoned() does.
class UnpackedArchive {
  public:
    UnpackedArchive(Draft folder, const ArchiveFacts& facts) : draft_(std::move(folder)), facts_(facts) {}

    const std::filesystem::path& folder() const { return draft_.path(); }
    const ArchiveFacts& facts() const { return facts_; }

  private:
    Draft draft_;
    ArchiveFacts facts_;
};

// Unpacks the regular files of a ZIP, tar or ISO 9660 file (isArchive) under safe names (safe_names.h), and
// what is told of them is in the facts. No link is made or followed, no archive in it is opened, and no
// program is started. An archive that is cut off gives what comes before. Fails with inputNotUsable where the
// file is no such archive, holds no file, or is over a limit; with outputNotWritable where the disk is full;
// with cancelled. Then nothing is left.
Result<std::shared_ptr<const UnpackedArchive>> unpack(const std::filesystem::path& archive,
                                                      Progress& progress, const UnpackLimits& limits = {});

// Where copies lie: unpacked, in the user's data folder.
std::filesystem::path unpackedFolder();

// Removes what programs that were killed left there.
void removeAbandoned();

}  // namespace macula::unpack
