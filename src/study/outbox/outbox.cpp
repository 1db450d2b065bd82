#include "study/outbox/outbox.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <map>
#include <system_error>
#include <thread>
#include <utility>

#include "base/draft.h"
#include "base/private_file.h"
#include "base/user_folder.h"
#include "base/utc_time.h"
#include "dicom/stack/examination.h"
#include "study/open/file_identity.h"
#include "study/open/same_patient.h"
#include "study/outbox/sending.h"

namespace macula::study {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kDigitsOfId = 16;
constexpr std::size_t kFewestDigits = 4;
constexpr std::string_view kHexDigits = "0123456789abcdef";
constexpr const char* kLock = "lock";
constexpr std::chrono::milliseconds kLockIsTriedEvery{20};

bool isHex(std::string_view text) {
    return text.find_first_not_of(kHexDigits) == std::string_view::npos;
}

Error notThere() {
    return {ErrorCode::usage,
            Text("There is no such entry in the queue."),
            {},
            Text("It may have been sent or removed. macula pacs queue lists what waits.")};
}

Error notCopied(const fs::path& folder) {
    return {ErrorCode::outputNotWritable, Text("The objects could not be copied into the queue."),
            folder.string(), Text("Check the permissions of this folder and the free space.")};
}

FileLock lockOf(const fs::path& folder) {
    return FileLock(folder / kLock);
}

// The draft's name ends in 16 random digits, and so does the entry's.
std::string digitsOf(const Draft& draft) {
    const std::string name = draft.path().stem().string();
    return name.size() < kDigitsOfId ? std::string() : name.substr(name.size() - kDigitsOfId);
}

bool isConfirmed(const ToQueue& request, const Identity& found) {
    return std::ranges::any_of(request.patients, [&](const Identity& patient) {
        return samePatient(patient, found) == SamePatient::yes || patient == found;
    });
}

// A file may change between a person's answer and the copy: what was copied is looked at.
Result<void> checkCopy(const fs::path& copy, const ToQueue& request) {
    const dicom::Examination found = dicom::examine(copy);
    if (found.state != dicom::FileState::complete || found.sopInstanceUid.empty())
        return Error{ErrorCode::inputNotUsable,
                     Text("One of the files is no whole DICOM object; nothing was put into the queue."),
                     {},
                     Text("Leave it out, or write it again.")};
    if (!isConfirmed(request, identityOf(found)))
        return Error{ErrorCode::inputNotUsable,
                     Text("One of the files is of a patient or study that was not confirmed; nothing was put "
                          "into the queue."),
                     {},
                     Text("Send it again, and check the names in the question.")};
    return {};
}

Result<std::vector<OutboxFile>> copyFiles(const ToQueue& request, const fs::path& folder,
                                          Progress& progress) {
    std::vector<OutboxFile> copied;
    progress.beginStage(Text("Copying {} objects into the queue", request.files.size()),
                        std::max<std::size_t>(request.files.size(), 1));
    for (const ToQueue::File& file : request.files) {
        if (progress.cancelled())
            return Error{ErrorCode::cancelled, Text("Nothing was put into the queue."), {}, {}};
        const std::string name = std::to_string(copied.size() + 1) + ".dcm";
        std::error_code failure;
        fs::copy_file(file.path, folder / name, failure);
        if (!failure) fs::permissions(folder / name, fs::perms::owner_read | fs::perms::owner_write, failure);
        if (failure) return notCopied(folder.parent_path());
        MACULA_TRY_VOID(checkCopy(folder / name, request));
        copied.push_back({name, file.refused});
        progress.advance();
    }
    return copied;
}

// All of it is on the disk before the entry gets its name.
bool isOnDisk(const fs::path& folder) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return false;
    const bool synced = syncfs(descriptor) == 0;
    close(descriptor);
    return synced;
}

OutboxState stateOf(const OutboxEntry& entry, bool isReadable) {
    if (!isReadable) return OutboxState::damaged;
    return entry.record.refused() == entry.record.files.size() ? OutboxState::refused : OutboxState::waiting;
}

// What was stored, and what a killed program stored before.
void removeFilesWithoutNote(const fs::path& folder, const OutboxRecord& record) {
    std::vector<fs::path> gone;
    std::error_code failure;
    for (fs::directory_iterator each(folder, failure), end; !failure && each != end;
         each.increment(failure)) {
        const bool isNoted = std::ranges::any_of(
            record.files, [&](const OutboxFile& file) { return each->path().filename() == file.name; });
        if (each->path().extension() == ".dcm" && !isNoted) gone.push_back(each->path());
    }
    for (const fs::path& file : gone) fs::remove(file, failure);
}

// The files of the record after a try; those that were stored are left out.
std::vector<OutboxFile> filesAfter(const OutboxRecord& record, const fs::path& folder,
                                   const std::vector<OutboxFile>& tried, const FilesSent& outcome) {
    std::map<fs::path, Reason> refused;
    for (const net::NotSent& each : outcome.refused) refused[each.file] = {each.why, each.advice};
    std::vector<OutboxFile> files;
    for (const OutboxFile& file : record.files) {
        const fs::path path = folder / file.name;
        const bool wasTried =
            std::ranges::any_of(tried, [&](const OutboxFile& each) { return each.name == file.name; });
        const auto reason = refused.find(path);
        if (reason != refused.end()) {
            files.push_back({file.name, reason->second});
        } else if (!wasTried || std::ranges::find(outcome.left, path) != outcome.left.end()) {
            files.push_back(file);
        }
    }
    return files;
}

}  // namespace

std::size_t OutboxEntry::toSend(SendWhich which) const {
    if (state == OutboxState::damaged) return 0;
    return record.files.size() - (which == SendWhich::refusedToo ? 0 : record.refused());
}

fs::path outboxFolder() {
    return userDataFolder() / "outbox";
}

Result<Outbox> Outbox::open(fs::path folder, OutboxLimits limits) {
    MACULA_TRY_VOID(makePrivateFolder(folder));
    removeAbandonedDrafts(folder);
    return Outbox(std::move(folder), limits);
}

std::vector<OutboxEntry> Outbox::entries() const {
    std::vector<OutboxEntry> entries;
    std::error_code failure;
    for (fs::directory_iterator each(folder_, failure), end; !failure && each != end;
         each.increment(failure)) {
        std::error_code gone;
        OutboxEntry entry{.id = each->path().filename().string(), .folder = each->path(), .record = {}};
        if (entry.id.size() != kDigitsOfId || !isHex(entry.id) || !each->is_directory(gone)) continue;
        auto record = readOutboxRecord(entry.folder);
        const bool isReadable = record.ok();
        if (isReadable) entry.record = *std::move(record);
        const bool isFree = lockOf(entry.folder).isFree();
        if (!fs::is_directory(entry.folder, gone)) continue;  // sent or removed meanwhile
        entry.state = isFree ? stateOf(entry, isReadable) : OutboxState::sending;
        entries.push_back(std::move(entry));
    }
    std::ranges::sort(entries, [](const OutboxEntry& a, const OutboxEntry& b) {
        return std::pair(a.record.queuedAt, a.id) < std::pair(b.record.queuedAt, b.id);
    });
    return entries;
}

Result<OutboxEntry> Outbox::find(std::string_view digits) const {
    if (digits.size() < kFewestDigits || !isHex(digits))
        return Error{ErrorCode::usage,
                     Text("An entry of the queue is named by at least {} hexadecimal digits.", kFewestDigits),
                     {},
                     Text("macula pacs queue lists them.")};
    std::vector<OutboxEntry> fitting = entries();
    std::erase_if(fitting, [&](const OutboxEntry& entry) { return !entry.id.starts_with(digits); });
    if (fitting.empty()) return notThere();
    if (fitting.size() > 1)
        return Error{ErrorCode::usage,
                     Text("Several entries of the queue begin with these digits."),
                     {},
                     Text("Give more of them.")};
    return std::move(fitting.front());
}

Result<FileLock> Outbox::lock(const std::string& id) const {
    const auto until = std::chrono::steady_clock::now() + limits_.patience;
    for (;;) {
        std::error_code failure;
        if (id.size() != kDigitsOfId || !isHex(id) || !fs::is_directory(folderOf(id), failure))
            return notThere();
        FileLock taken = lockOf(folderOf(id));
        if (taken.isOurs()) {
            // Whoever had it before may have removed the entry.
            if (!fs::is_directory(folderOf(id), failure)) return notThere();
            return taken;
        }
        if (std::chrono::steady_clock::now() >= until)
            return Error{ErrorCode::usage,
                         Text("These objects are being sent at this moment."),
                         {},
                         Text("Wait until that is done.")};
        std::this_thread::sleep_for(kLockIsTriedEvery);
    }
}

Result<void> Outbox::checkRoom(const ToQueue& request) const {
    std::uintmax_t bytes = 0;
    for (const ToQueue::File& file : request.files) {
        std::error_code failure;
        const std::uintmax_t size = fs::file_size(file.path, failure);
        if (failure)
            return Error{ErrorCode::inputNotUsable,
                         Text("One of the files is gone; nothing was put into the queue."),
                         file.path.string(),
                         {}};
        bytes += size;
    }
    std::error_code failure;
    const fs::space_info space = fs::space(folder_, failure);
    if (failure) return notCopied(folder_);
    if (space.available >= limits_.leastFreeBytes && space.available - limits_.leastFreeBytes >= bytes)
        return {};
    return Error{ErrorCode::outputNotWritable, Text("The disk is too full to keep objects in the queue."),
                 folder_.string(), Text("Free some space, then send them again.")};
}

Result<std::string> Outbox::queue(const ToQueue& request, Progress& progress) {
    MACULA_CHECK(!request.files.empty() && !request.archive.empty());
    MACULA_TRY_VOID(checkRoom(request));
    auto draft = Draft::beside(folder_ / "entry", Draft::Kind::folder);
    if (!draft) return notCopied(folder_);
    MACULA_TRY_VOID(makePrivateFolder(draft->path()));
    OutboxRecord record{.archive = request.archive,
                        .address = request.address,
                        .patients = request.patients,
                        .queuedAt = nowInUtcMs(),
                        .tries = request.tries,
                        .triedAt = request.tries > 0 ? nowInUtc() : std::string(),
                        .trouble = request.trouble,
                        .files = {}};
    MACULA_TRY(record.files, copyFiles(request, draft->path(), progress));
    MACULA_TRY_VOID(writeOutboxRecord(draft->path(), record));
    const std::string id = digitsOf(*draft);
    std::error_code failure;
    if (!isOnDisk(draft->path())) return notCopied(folder_);
    fs::rename(draft->path(), folderOf(id), failure);
    if (failure) return notCopied(folder_);
    isOnDisk(folder_);  // best effort: the entry is there even if this fails
    return id;
}

Result<OutboxSent> Outbox::send(const std::string& id, net::Archive& archive, Progress& progress,
                                Which which) {
    MACULA_TRY(const FileLock locked, lock(id));
    const fs::path folder = folderOf(id);
    MACULA_TRY(OutboxRecord record, readOutboxRecord(folder));
    std::vector<OutboxFile> tried;
    std::vector<fs::path> paths;
    for (const OutboxFile& file : record.files) {
        if (file.refused && which == Which::waiting) continue;
        tried.push_back(file);
        paths.push_back(folder / file.name);
    }
    const FilesSent outcome = sendFiles(archive, paths, progress);
    record.files = filesAfter(record, folder, tried, outcome);
    const OutboxSent sent{.stored = outcome.stored,
                          .refused = record.refused(),
                          .left = record.files.size() - record.refused(),
                          .trouble = outcome.trouble};
    if (record.files.empty()) {
        MACULA_TRY(const Draft gone, Draft::of(folder));
        return sent;
    }
    const bool wasCancelled = outcome.trouble && outcome.trouble->code == ErrorCode::cancelled;
    if (!wasCancelled) {
        ++record.tries;
        record.triedAt = nowInUtc();
        record.trouble = outcome.trouble ? std::optional(reasonOf(*outcome.trouble)) : std::nullopt;
    }
    MACULA_TRY_VOID(writeOutboxRecord(folder, record));
    removeFilesWithoutNote(folder, record);
    return sent;
}

Result<void> Outbox::readdress(const std::string& id, const std::string& address) {
    MACULA_TRY(const FileLock locked, lock(id));
    MACULA_TRY(OutboxRecord record, readOutboxRecord(folderOf(id)));
    record.address = address;
    return writeOutboxRecord(folderOf(id), record);
}

Result<void> Outbox::remove(const std::string& id) {
    MACULA_TRY(const FileLock locked, lock(id));
    MACULA_TRY(const Draft gone, Draft::of(folderOf(id)));
    return {};
}

}  // namespace macula::study
