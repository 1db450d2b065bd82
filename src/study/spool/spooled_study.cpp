#include "study/spool/spooled_study.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "base/file_lock.h"
#include "base/parallel.h"
#include "dicom/stack/examination.h"
#include "study/open/file_identity.h"
#include "study/open/same_patient.h"
#include "study/spool/same_object.h"

namespace macula::study {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kDigitsOfName = 32;
constexpr std::chrono::milliseconds kLockIsTriedEvery{100};

bool lostLetters(const std::string& name) {
    return name.find('?') != std::string::npos || name.find("\uFFFD") != std::string::npos;
}

}  // namespace

bool isWorthKeeping(const dicom::Examination& found) {
    // A file that is cut off in its pixels is kept: the archive may have it so, and what opens the study says
    // it.
    const bool canBeRead =
        found.state == dicom::FileState::complete || found.state == dicom::FileState::truncated;
    return canBeRead && !found.sopInstanceUid.empty();
}

// The lock is a file beside the folder of the study, in which only instances lie.
struct SpooledStudy::Locked {
    FileLock file;
};

SpooledStudy::SpooledStudy(fs::path folder, std::string studyInstanceUid, InstallationKey key,
                           const SpoolLimits& limits)
    : folder_(std::move(folder)),
      studyInstanceUid_(std::move(studyInstanceUid)),
      key_(key),
      limits_(limits),
      arriving_(folder_.parent_path(), limits) {}

SpooledStudy::~SpooledStudy() = default;

Result<std::unique_ptr<SpooledStudy>> SpooledStudy::open(fs::path folder, std::string studyInstanceUid,
                                                         InstallationKey key, const SpoolLimits& limits,
                                                         const CancelToken& cancel) {
    MACULA_TRY_VOID(makePrivateFolder(folder));
    MACULA_TRY(const fs::path arriving, ArrivingFiles::prepareFolder(folder.parent_path()));
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
        if (!isWorthKeeping(found) || fileOf(found.sopInstanceUid) != files[i]) return;
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

std::uintmax_t SpooledStudy::mostBytesOfInstance() const {
    return arriving_.mostBytesOfFile();
}

Result<void> SpooledStudy::checkRoom(std::size_t arriving) const {
    if (bytes_ >= limits_.mostBytes)
        return Error{ErrorCode::archiveNotUsable,
                     Text("The study is larger than all that is kept of fetched studies."),
                     {},
                     Text("Fetch single series of it.")};
    if (instances_.size() + arriving >= limits_.mostInstancesOfStudy)
        return Error{
            ErrorCode::archiveNotUsable,
            Text("The archive sends more than {} images of one study.", limits_.mostInstancesOfStudy),
            {},
            Text("Fetch single series of it.")};
    return {};
}

Result<fs::path> SpooledStudy::place() {
    {
        const std::lock_guard lock(mutex_);
        MACULA_TRY_VOID(checkRoom(arriving_.count()));
    }
    return arriving_.place();
}

Result<net::Receiver::Verdict> SpooledStudy::take(const fs::path& file, const net::InstanceKey& promised) {
    const std::optional<Draft> draft = arriving_.take(file);  // what is not kept goes with it
    const dicom::Examination found = dicom::examine(file);
    const bool isPromised =
        promised.sopInstanceUid.empty() || promised.sopInstanceUid == found.sopInstanceUid;
    if (isPromised || !isWorthKeeping(found)) return keep(file, found);
    ++ofOtherStudies_;
    return Verdict::refused;
}

Result<net::Receiver::Verdict> SpooledStudy::keep(const fs::path& file, const dicom::Examination& found) {
    if (!isWorthKeeping(found)) {
        ++unreadable_;
        return Verdict::refused;
    }
    if (found.studyInstanceUid != studyInstanceUid_ || !takePatient(identityOf(found))) {
        ++ofOtherStudies_;
        return Verdict::refused;
    }
    {
        const std::lock_guard lock(mutex_);
        if (instances_.contains(found.sopInstanceUid)) return Verdict::hadAlready;
        MACULA_TRY_VOID(checkRoom(0));
        std::error_code failure;
        const std::uintmax_t size = fs::file_size(file, failure);
        fs::rename(file, fileOf(found.sopInstanceUid), failure);
        if (failure) return spoolNotWritable(folder_);
        instances_.insert(found.sopInstanceUid);
        bytes_ += size;
    }
    if (kept_) kept_();
    return Verdict::kept;
}

bool SpooledStudy::hasSame(const fs::path& file, const std::string& sopInstanceUid) const {
    return isSameObject(file, fileOf(sopInstanceUid));
}

void SpooledStudy::drop(const fs::path& file) noexcept {
    arriving_.drop(file);
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
