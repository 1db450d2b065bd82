#include "study/watch/watched_folder.h"

#include <sys/stat.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "dicom/stack/examination.h"
#include "study/open/file_identity.h"

namespace macula::study {

namespace fs = std::filesystem;

namespace {

// A file that ends early may still grow, on a share that is slow or after a pause. Then it is what it is.
constexpr int kQuietTimesForCutOff = 10;

std::optional<FolderIdentity> identityOfFolder(const fs::path& folder) {
    struct stat status {};
    if (stat(folder.c_str(), &status) != 0) return {};
    return FolderIdentity{status.st_dev, status.st_ino};
}

bool isImage(const dicom::Examination& found) {
    return found.kind == dicom::Examination::Kind::image;
}

}  // namespace

Result<std::vector<ArrivedStudy>> WatchedFolder::look(Clock::time_point now, Progress& progress) {
    const auto identity = identityOfFolder(folder_);
    MACULA_TRY(const dicom::FolderListing listing, dicom::listFiles(folder_, progress));
    // Another folder at the path is a share that was mounted or unmounted.
    const bool isOther = identity != identity_;
    identity_ = identity;
    if (isOther) {
        files_.clear();
        arriving_.clear();
    }
    note(listing, now, isOther);
    read(now, progress);
    return takeWhole(now);
}

void WatchedFolder::note(const dicom::FolderListing& listing, Clock::time_point now, bool areKnown) {
    std::map<fs::path, File> before = std::exchange(files_, {});
    // What cannot be listed now, as when a share hangs, would otherwise come back as new.
    if (!listing.unreadable.empty()) files_ = before;
    for (const fs::path& path : listing.files) {
        std::error_code failure;
        File file;
        file.bytes = fs::file_size(path, failure);
        if (!failure) file.written = fs::last_write_time(path, failure);
        if (failure) continue;  // it vanished
        const auto was = before.find(path);
        const bool isSame =
            was != before.end() && was->second.bytes == file.bytes && was->second.written == file.written;
        file.changed = isSame ? was->second.changed : now;
        file.isKnown = areKnown || (isSame && was->second.isKnown);
        files_.insert_or_assign(path, file);
    }
}

void WatchedFolder::read(Clock::time_point now, const Progress& progress) {
    for (auto& [path, file] : files_) {
        if (progress.cancelled()) return;
        if (file.isKnown || now - file.changed < quiet_) continue;
        const dicom::Examination found = dicom::examine(path, progress.token());
        const bool isCutOff =
            found.state == dicom::FileState::truncated || found.state == dicom::FileState::damaged;
        if (isCutOff && now - file.changed < kQuietTimesForCutOff * quiet_) continue;
        file.isKnown = true;
        if (found.studyInstanceUid.empty() || found.state == dicom::FileState::damaged) continue;
        Arriving& arriving = arriving_[found.studyInstanceUid];
        ArrivedStudy& study = arriving.study;
        if (study.file.empty() || (study.images == 0 && isImage(found))) {
            study.folder = folder_;
            study.file = path;
            study.identity = identityOf(found);
        }
        study.images += isImage(found) ? 1 : 0;
        if (!found.modality.empty()) study.modalities.insert(found.modality);
        arriving.changed = std::max(arriving.changed, file.changed);
        arriving.folders.insert(path.parent_path());
    }
}

// Where a file still changes beside those of a study, it may be one of its own.
std::vector<ArrivedStudy> WatchedFolder::takeWhole(Clock::time_point now) {
    std::set<fs::path> busy;
    for (const auto& [path, file] : files_) {
        if (!file.isKnown) busy.insert(path.parent_path());
    }
    std::vector<ArrivedStudy> whole;
    for (auto each = arriving_.begin(); each != arriving_.end();) {
        const Arriving& arriving = each->second;
        const bool isQuiet = now - arriving.changed >= quiet_ &&
                             std::ranges::none_of(arriving.folders, [&](const fs::path& folder) {
                                 return busy.contains(folder);
                             });
        if (!isQuiet) {
            ++each;
            continue;
        }
        if (arriving.study.images > 0) whole.push_back(arriving.study);
        each = arriving_.erase(each);
    }
    return whole;
}

}  // namespace macula::study
