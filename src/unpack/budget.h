// How much an archive may unpack to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

#include "base/result.h"

namespace macula::unpack {

// Studies compress to a half or a third, and masks of segments to a hundredth; a file that was made to fill
// disks (a bomb) grows a thousandfold and more. Small ones do no harm.
struct UnpackLimits {
    std::size_t mostEntries = 200'000;
    std::uintmax_t mostBytes = 64ull << 30;
    std::uintmax_t mostTimes = 200;              // as many bytes as the archive has
    std::uintmax_t bytesInAnyCase = 1ull << 30;  // of which mostTimes does not matter
    std::uintmax_t mostBytesOfFile = 8ull << 30;
    std::uintmax_t mostTimesOfFile = 500;
    std::uintmax_t fileBytesInAnyCase = 256ull << 20;
    std::uintmax_t leastFreeBytes = 1ull << 30;  // left on the disk
};

// Counts what comes out of one archive. Fails with inputNotUsable at a limit of the archive, and with
// outputNotWritable where the disk has too little space; then nothing of the archive is to be kept, because
// nobody could tell what is missing.
class Budget {
  public:
    // `folder` lies on the disk that is written to.
    Budget(const UnpackLimits& limits, const std::filesystem::path& archive, std::filesystem::path folder);

    Result<void> beginEntry(std::uint64_t positionBytes);
    // Of the last entry; positions are those in the archive.
    Result<void> spend(std::size_t bytes, std::uint64_t positionBytes);

    Error diskFull() const;  // for a write that failed

  private:
    Error refused(Text why) const;

    const UnpackLimits limits_;
    const std::filesystem::path archive_;
    const std::filesystem::path folder_;
    std::uintmax_t archiveBytes_ = 0;
    std::uintmax_t bytes_ = 0;
    std::uintmax_t uncheckedBytes_ = 0;  // since the disk was last asked for its space
    std::uintmax_t fileBytes_ = 0;
    std::uint64_t fileBegan_ = 0;
    std::size_t entries_ = 0;
};

}  // namespace macula::unpack
