#include "study/spool/spool.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace macula::study {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kDigitsOfFolder = 32;

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

Result<Spool> Spool::open(const fs::path& folder, SpoolLimits limits) {
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (!failure) fs::permissions(folder, fs::perms::owner_all, failure);
    if (failure)
        return Error{ErrorCode::outputNotWritable, Text("The folder for fetched studies cannot be made."),
                     folder.string(), Text("Check the permissions of the folder above it.")};
    MACULA_TRY(const InstallationKey key, InstallationKey::ofUser());
    return Spool(folder, key, limits);
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

Result<std::unique_ptr<SpooledStudy>> Spool::study(const std::string& studyInstanceUid) {
    return SpooledStudy::open(folderOf(studyInstanceUid), studyInstanceUid, key_, limits_);
}

Result<std::size_t> Spool::purge(std::uintmax_t mostBytes) {
    const std::vector<SpoolEntry> all = entries();
    std::uintmax_t kept = 0;
    std::size_t removed = 0;
    for (const SpoolEntry& entry : all) {
        kept += entry.bytes;
        if (kept <= mostBytes) continue;
        // The lock is held while its folder goes: nobody fetches into it.
        auto locked = study(entry.record.studyInstanceUid);
        if (!locked || (*locked)->folder() != entry.folder) continue;
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
