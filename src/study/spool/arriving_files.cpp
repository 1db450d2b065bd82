#include "study/spool/arriving_files.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace macula::study {

namespace fs = std::filesystem;

namespace {

constexpr const char* kArriving = "arriving";

}  // namespace

Error spoolNotWritable(const fs::path& path) {
    return {ErrorCode::outputNotWritable, Text("The folder for fetched studies cannot be written."),
            path.string(), Text("Check its permissions and the free space.")};
}

Result<void> makePrivateFolder(const fs::path& folder) {
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (!failure) fs::permissions(folder, fs::perms::owner_all, failure);
    if (failure) return spoolNotWritable(folder);
    return {};
}

Result<fs::path> ArrivingFiles::prepareFolder(const fs::path& spool) {
    const fs::path folder = spool / kArriving;
    MACULA_TRY_VOID(makePrivateFolder(folder));
    removeAbandonedDrafts(folder);
    return folder;
}

ArrivingFiles::ArrivingFiles(const fs::path& spool, const SpoolLimits& limits)
    : folder_(spool / kArriving), limits_(limits) {}

std::uintmax_t ArrivingFiles::mostBytesOfFile() const {
    std::error_code failure;
    const fs::space_info space = fs::space(folder_, failure);
    if (failure || space.available <= limits_.leastFreeBytes) return 0;
    return std::min(limits_.mostBytesOfInstance, space.available - limits_.leastFreeBytes);
}

Result<fs::path> ArrivingFiles::place() {
    std::error_code failure;
    const fs::space_info space = fs::space(folder_, failure);
    if (failure) return spoolNotWritable(folder_);
    if (space.available < limits_.leastFreeBytes)
        return Error{ErrorCode::outputNotWritable, Text("The disk for fetched studies is full."),
                     folder_.parent_path().string(),
                     Text("Free some space, or remove fetched studies with macula pacs purge. What came so "
                          "far is kept.")};
    MACULA_TRY(Draft draft, Draft::beside(folder_ / "instance.dcm", Draft::Kind::file));
    fs::permissions(draft.path(), fs::perms::owner_read | fs::perms::owner_write, failure);
    if (failure) return spoolNotWritable(folder_);
    fs::path path = draft.path();
    const std::lock_guard lock(mutex_);
    drafts_.emplace(path, std::move(draft));
    return path;
}

std::optional<Draft> ArrivingFiles::take(const fs::path& file) {
    const std::lock_guard lock(mutex_);
    auto found = drafts_.extract(file);
    if (found.empty()) return {};
    return std::move(found.mapped());
}

void ArrivingFiles::drop(const fs::path& file) noexcept {
    const std::lock_guard lock(mutex_);
    drafts_.erase(file);
}

std::size_t ArrivingFiles::count() const {
    const std::lock_guard lock(mutex_);
    return drafts_.size();
}

}  // namespace macula::study
