#include "unpack/budget.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace macula::unpack {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kBytesBetweenLooks = 64ull << 20;
constexpr std::uintmax_t kBytesOfEmptyFile = 4096;  // a block of the disk
constexpr std::uintmax_t kGigabyte = 1'000'000'000;

}  // namespace

Budget::Budget(const UnpackLimits& limits, const fs::path& archive, fs::path folder)
    : limits_(limits), archive_(archive), folder_(std::move(folder)), uncheckedBytes_(kBytesBetweenLooks) {
    std::error_code unknown;
    const std::uintmax_t bytes = fs::file_size(archive, unknown);
    archiveBytes_ = unknown ? 0 : bytes;
}

Error Budget::refused(Text why) const {
    return {ErrorCode::inputNotUsable, std::move(why), archive_.string(),
            Text("Unpack it with another program if you trust it, and open the folder.")};
}

Error Budget::diskFull() const {
    return {ErrorCode::outputNotWritable,
            Text("The disk has too little space to unpack the archive, and nothing of it was kept."),
            folder_.string(),
            Text("Free space there, or choose a data folder on another disk: XDG_DATA_HOME names it.")};
}

Result<void> Budget::beginEntry(std::uint64_t positionBytes) {
    fileBytes_ = 0;
    fileBegan_ = positionBytes;
    if (++entries_ > limits_.mostEntries)
        return refused(
            Text("The archive holds more than {} files, which Macula does not unpack.", limits_.mostEntries));
    return spend(kBytesOfEmptyFile, positionBytes);
}

Result<void> Budget::spend(std::size_t bytes, std::uint64_t positionBytes) {
    bytes_ += bytes;
    fileBytes_ += bytes;
    uncheckedBytes_ += bytes;
    if (bytes_ > limits_.mostBytes || fileBytes_ > limits_.mostBytesOfFile)
        return refused(Text(
            "The archive unpacks to more than {} GB, or one file in it to more than {} GB, which Macula does "
            "not unpack.",
            limits_.mostBytes / kGigabyte, limits_.mostBytesOfFile / kGigabyte));
    const std::uintmax_t read = std::max(positionBytes, fileBegan_) - fileBegan_;
    const bool growsAsWhole = bytes_ > limits_.bytesInAnyCase && bytes_ / limits_.mostTimes > archiveBytes_;
    const bool growsAsFile =
        fileBytes_ > limits_.fileBytesInAnyCase && fileBytes_ / limits_.mostTimesOfFile > read;
    if (growsAsWhole || growsAsFile)
        return refused(
            Text("The archive unpacks to hundreds of times its size, as files do that are made to fill "
                 "disks. Nothing of it was kept."));
    if (uncheckedBytes_ < kBytesBetweenLooks) return {};
    uncheckedBytes_ = 0;
    std::error_code unknown;
    const fs::space_info space = fs::space(folder_, unknown);
    if (!unknown && space.available < limits_.leastFreeBytes) return diskFull();
    return {};
}

}  // namespace macula::unpack
