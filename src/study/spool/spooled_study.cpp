#include "study/spool/spooled_study.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "base/draft.h"
#include "base/file_lock.h"
#include "base/parallel.h"
#include "dicom/stack/examination.h"
#include "study/open/file_identity.h"
#include "study/open/same_patient.h"

namespace macula::study {

namespace fs = std::filesystem;

namespace {

constexpr const char* kArriving = "arriving";
constexpr std::size_t kDigitsOfName = 32;
constexpr std::chrono::milliseconds kLockIsTriedEvery{100};

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

bool lostLetters(const std::string& name) {
    return name.find('?') != std::string::npos || name.find("\uFFFD") != std::string::npos;
}

// A file that is cut off in its pixels is kept: the archive may have it so, and what opens the study says it.
bool canBeRead(const dicom::Examination& found) {
    return found.state == dicom::FileState::complete || found.state == dicom::FileState::truncated;
}

}  // namespace

// The lock is a file beside the folder of the study, in which only instances lie.
struct SpooledStudy::Locked {
    FileLock file;
};

SpooledStudy::SpooledStudy(fs::path folder, std::string studyInstanceUid, InstallationKey key,
                           const SpoolLimits& limits)
    : folder_(std::move(folder)),
      studyInstanceUid_(std::move(studyInstanceUid)),
      key_(key),
      limits_(limits) {}

SpooledStudy::~SpooledStudy() = default;

Result<std::unique_ptr<SpooledStudy>> SpooledStudy::open(fs::path folder, std::string studyInstanceUid,
                                                         InstallationKey key, const SpoolLimits& limits,
                                                         const CancelToken& cancel) {
    const fs::path arriving = folder.parent_path() / kArriving;
    MACULA_TRY_VOID(makePrivateFolder(folder));
    MACULA_TRY_VOID(makePrivateFolder(arriving));
    std::unique_ptr<SpooledStudy> study(
        new SpooledStudy(std::move(folder), std::move(studyInstanceUid), key, limits));
    study->locked_ =
        std::make_unique<Locked>(Locked{FileLock(arriving / (study->folder_.filename().string() + ".lock"))});
    const auto until = std::chrono::steady_clock::now() + limits.patience;
    while (!study->locked_->file.isOurs()) {
        if (cancel.cancelled()) return Error{ErrorCode::cancelled, Text("Fetching was cancelled."), {}, {}};
        if (std::chrono::steady_clock::now() >= until)
            return Error{ErrorCode::usage,
                         Text("Another program is fetching this study."),
                         {},
                         Text("Wait until it is done.")};
        std::this_thread::sleep_for(kLockIsTriedEvery);
    }
    removeAbandonedDrafts(arriving);
    MACULA_TRY_VOID(study->readInstances());
    return study;
}

Result<void> SpooledStudy::readInstances() {
    std::vector<fs::path> files;
    std::error_code failure;
    for (fs::directory_iterator entry(folder_, failure), end; !failure && entry != end;
         entry.increment(failure)) {
        if (entry->path().extension() == ".dcm") files.push_back(entry->path());
    }
    std::mutex mutex;
    parallelFor(files.size(), [&](std::size_t i) {
        const dicom::Examination found = dicom::examine(files[i]);
        // What a person put there, or what a disk lost, is fetched again.
        if (!canBeRead(found) || fileOf(found.sopInstanceUid) != files[i]) return;
        std::error_code gone;
        const std::uintmax_t size = fs::file_size(files[i], gone);
        const std::lock_guard lock(mutex);
        instances_.insert(found.sopInstanceUid);
        if (!patient_) patient_ = identityOf(found);
        bytes_ += gone ? 0 : size;
    });
    return {};
}

Result<void> SpooledStudy::expect(const Identity& patient) {
    Identity known = patient;
    if (lostLetters(known.patientName)) known.patientName.clear();
    const std::lock_guard lock(mutex_);
    if (patient_ && samePatient(*patient_, known) == SamePatient::no)
        return Error{ErrorCode::inputNotUsable,
                     Text("The images of this study that were fetched before name another patient than the "
                          "archive does now."),
                     folder_.string(),
                     Text("Tell the administrator of the archive. To fetch the study anew, remove what was "
                          "fetched of it.")};
    expected_ = std::move(known);
    return {};
}

bool SpooledStudy::takePatient(const Identity& patient) {
    const std::lock_guard lock(mutex_);
    const bool isExpected = !expected_ || samePatient(*expected_, patient) != SamePatient::no;
    const bool isOfTheFiles = !patient_ || samePatient(*patient_, patient) != SamePatient::no;
    if (isExpected && isOfTheFiles && !patient_) patient_ = patient;
    return isExpected && isOfTheFiles;
}

std::set<std::string> SpooledStudy::instances() const {
    const std::lock_guard lock(mutex_);
    return instances_;
}

fs::path SpooledStudy::fileOf(const std::string& sopInstanceUid) const {
    return folder_ / (key_.digestOf(sopInstanceUid).substr(0, kDigitsOfName) + ".dcm");
}

// Asked while files grow: several at once must not fill the disk.
std::uintmax_t SpooledStudy::mostBytesOfInstance() const {
    std::error_code failure;
    const fs::space_info space = fs::space(folder_, failure);
    if (failure || space.available <= limits_.leastFreeBytes) return 0;
    return std::min(limits_.mostBytesOfInstance, space.available - limits_.leastFreeBytes);
}

Result<fs::path> SpooledStudy::place() {
    std::error_code failure;
    const fs::space_info space = fs::space(folder_, failure);
    if (failure) return spoolNotWritable(folder_);
    if (space.available < limits_.leastFreeBytes)
        return Error{ErrorCode::outputNotWritable, Text("The disk for fetched studies is full."),
                     folder_.string(),
                     Text("Free some space, or remove fetched studies with macula pacs purge. What came so "
                          "far is kept.")};
    MACULA_TRY(Draft draft,
               Draft::beside(folder_.parent_path() / kArriving / "instance.dcm", Draft::Kind::file));
    fs::permissions(draft.path(), fs::perms::owner_read | fs::perms::owner_write, failure);
    if (failure) return spoolNotWritable(folder_);
    const std::lock_guard lock(mutex_);
    if (bytes_ >= limits_.mostBytes)
        return Error{ErrorCode::archiveNotUsable,
                     Text("The study is larger than all that is kept of fetched studies."),
                     {},
                     Text("Fetch single series of it.")};
    if (instances_.size() + drafts_.size() >= limits_.mostInstancesOfStudy)
        return Error{
            ErrorCode::archiveNotUsable,
            Text("The archive sends more than {} images of one study.", limits_.mostInstancesOfStudy),
            {},
            Text("Fetch single series of it.")};
    fs::path path = draft.path();
    drafts_.emplace(path, std::move(draft));
    return path;
}

Result<net::Receiver::Verdict> SpooledStudy::take(const fs::path& file, const net::InstanceKey& promised) {
    const dicom::Examination found = dicom::examine(file);
    const bool isReadable = canBeRead(found) && !found.sopInstanceUid.empty();
    const bool isPromised =
        found.studyInstanceUid == studyInstanceUid_ &&
        (promised.sopInstanceUid.empty() || promised.sopInstanceUid == found.sopInstanceUid);
    const bool isOurs = isReadable && isPromised && takePatient(identityOf(found));
    if (!isReadable) ++unreadable_;
    if (isReadable && !isOurs) ++ofOtherStudies_;
    if (!isOurs) {
        drop(file);
        return Verdict::refused;
    }
    {
        const std::lock_guard lock(mutex_);
        const fs::path name = fileOf(found.sopInstanceUid);
        if (instances_.contains(found.sopInstanceUid)) {
            drafts_.erase(file);
            return Verdict::hadAlready;
        }
        std::error_code failure;
        const std::uintmax_t size = fs::file_size(file, failure);
        fs::rename(file, name, failure);
        drafts_.erase(file);
        if (failure) return spoolNotWritable(folder_);
        instances_.insert(found.sopInstanceUid);
        bytes_ += size;
    }
    if (kept_) kept_();
    return Verdict::kept;
}

void SpooledStudy::drop(const fs::path& file) noexcept {
    const std::lock_guard lock(mutex_);
    drafts_.erase(file);
}

Result<void> SpooledStudy::finish(SpoolRecord record) {
    record.studyInstanceUid = studyInstanceUid_;
    if (const int descriptor = ::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); descriptor >= 0) {
        const bool isOnDisk = syncfs(descriptor) == 0;
        close(descriptor);
        if (!isOnDisk) return spoolNotWritable(folder_);
    }
    return writeSpoolRecord(folder_, record);
}

}  // namespace macula::study
