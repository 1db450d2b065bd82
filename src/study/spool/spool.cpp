#include "study/spool/spool.h"

#include <algorithm>
#include <limits>
#include <system_error>
#include <utility>

namespace macula::study {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kDigitsOfFolder = 32;

Error noFolder(const fs::path& folder) {
    return {ErrorCode::outputNotWritable, Text("The folder for fetched studies cannot be made."),
            folder.string(), Text("Check the permissions of the folder above it.")};
}

Result<SpoolEntry> entryOf(const fs::path& folder) {
    SpoolEntry entry;
    entry.folder = folder;
    MACULA_TRY(entry.record, readSpoolRecord(folder));
    std::error_code failure;
    entry.used = fs::last_write_time(spoolRecordFile(folder), failure);
    for (fs::directory_iterator file(folder, failure), end; !failure && file != end;
         file.increment(failure)) {
        std::error_code gone;
        const std::uintmax_t bytes = file->file_size(gone);
        if (gone) continue;
        entry.bytes += bytes;
        entry.instances += file->path().extension() == ".dcm" ? 1 : 0;
    }
    return entry;
}

}  // namespace

fs::path spoolFolder() {
    return userDataFolder() / "fetched";
}

std::optional<SpoolRecord> useSpooled(const fs::path& folder) {
    if (folder.parent_path() != spoolFolder()) return std::nullopt;
    auto record = readSpoolRecord(folder);
    if (!record) return std::nullopt;
    std::error_code ignored;
    fs::last_write_time(spoolRecordFile(folder), fs::file_time_type::clock::now(), ignored);
    return *std::move(record);
}

Result<Spool> Spool::open(const fs::path& folder, SpoolLimits limits) {
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (!failure) fs::permissions(folder, fs::perms::owner_all, failure);
    if (failure) return noFolder(folder);
    MACULA_TRY(const InstallationKey key, InstallationKey::ofUser());
    return Spool(folder, key, limits);
}

Result<Spool> Spool::chosen(const fs::path& folder) {
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure) return noFolder(folder);
    MACULA_TRY(const InstallationKey key, InstallationKey::ofUser());
    Spool spool(folder, key, {.mostBytes = std::numeric_limits<std::uintmax_t>::max()});
    spool.isChosen_ = true;
    return spool;
}

std::vector<SpoolEntry> Spool::entries() const {
    std::vector<SpoolEntry> entries;
    std::error_code failure;
    for (fs::directory_iterator each(folder_, failure), end; !failure && each != end;
         each.increment(failure)) {
        std::error_code gone;
        if (!each->is_directory(gone)) continue;
        if (auto entry = entryOf(each->path()); entry) entries.push_back(*std::move(entry));
    }
    std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.used > b.used; });
    return entries;
}

fs::path Spool::folderOf(const std::string& studyInstanceUid) const {
    return folder_ / key_.digestOf(studyInstanceUid).substr(0, kDigitsOfFolder);
}

Result<std::unique_ptr<SpooledStudy>> Spool::study(const std::string& studyInstanceUid,
                                                   const CancelToken& cancel) {
    const fs::path folder = folderOf(studyInstanceUid);
    {
        const std::lock_guard lock(given_->mutex);
        given_->folders.insert(folder);
    }
    return SpooledStudy::open(folder, studyInstanceUid, key_, limits_, cancel);
}

Result<std::size_t> Spool::purge(std::uintmax_t mostBytes, Purged which) {
    const std::vector<SpoolEntry> all = entries();
    std::uintmax_t kept = 0;
    std::size_t removed = 0;
    std::set<fs::path> given;
    {
        const std::lock_guard lock(given_->mutex);
        given = given_->folders;
    }
    for (const SpoolEntry& entry : all) {
        // What somebody sent may be nowhere else.
        if (which == Purged::fetched && entry.record.source.empty()) continue;
        kept += entry.bytes;
        if (kept <= mostBytes || given.contains(entry.folder)) continue;
        // The lock is held while its folder goes: nobody fetches into it.
        SpoolLimits atOnce = limits_;
        atOnce.patience = {};
        auto locked = SpooledStudy::open(entry.folder, entry.record.studyInstanceUid, key_, atOnce);
        if (!locked) continue;
        std::error_code failure;
        fs::remove_all(entry.folder, failure);
        if (!failure) fs::remove(spoolRecordFile(entry.folder), failure);
        if (failure)
            return Error{ErrorCode::outputNotWritable, Text("A fetched study cannot be removed."),
                         entry.folder.string(), Text("Check its permissions.")};
        kept -= entry.bytes;
        ++removed;
    }
    return removed;
}

}  // namespace macula::study
