// A study in the spool, into which instances are received.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>

#include "base/installation_key.h"
#include "base/progress.h"
#include "net/archive/receiver.h"
#include "study/open/identity.h"
#include "study/spool/arriving_files.h"
#include "study/spool/spool_limits.h"
#include "study/spool/spool_record.h"

namespace macula::dicom {
struct Examination;
}

namespace macula::study {

// Whether the header can be read, and names an instance.
bool isWorthKeeping(const dicom::Examination& found);

// Keeps a file only if the bounded walk of dicom/read/outline.h can read its header, and if it is an instance
// of this study and of this patient: what an archive answers for one patient is never kept with another's.
// Locked against other programs while it exists.
class SpooledStudy : public net::Receiver {
  public:
    // Makes the folder if it is missing, removes what was left half received, and reads which instances are
    // there. Fails with usage while another program fetches the study.
    static Result<std::unique_ptr<SpooledStudy>> open(std::filesystem::path folder,
                                                      std::string studyInstanceUid, InstallationKey key,
                                                      const SpoolLimits& limits,
                                                      const CancelToken& cancel = {});
    ~SpooledStudy() override;

    const std::filesystem::path& folder() const { return folder_; }

    // Whose study it is, as the archive answered; without it, the patient of the first file counts. A name
    // that lost letters on its way (? or U+FFFD) counts as none. Fails with inputNotUsable where files of
    // somebody else are there.
    Result<void> expect(const Identity& patient);
    // Called after each instance that was kept, by the thread that received it.
    void onKept(std::function<void()> listener) { kept_ = std::move(listener); }

    std::set<std::string> instances() const;                        // SOP Instance UIDs
    std::size_t ofOtherStudies() const { return ofOtherStudies_; }  // refused: of another study or patient
    std::size_t unreadable() const { return unreadable_; }

    // Writes all files to the disk, then the record.
    Result<void> finish(SpoolRecord record);

    Result<std::filesystem::path> place() override;
    Result<Verdict> take(const std::filesystem::path& file, const net::InstanceKey& promised) override;
    // The same for a file of somebody else on the same file system, who has looked at it: what is not kept
    // stays with them.
    Result<Verdict> keep(const std::filesystem::path& file, const dicom::Examination& found);
    // Of a file that came before: whether this is the same object (isSameObject).
    bool hasSame(const std::filesystem::path& file, const std::string& sopInstanceUid) const;
    void drop(const std::filesystem::path& file) noexcept override;
    std::uintmax_t mostBytesOfInstance() const override;

  private:
    struct Locked;  // the folder, against other programs

    SpooledStudy(std::filesystem::path folder, std::string studyInstanceUid, InstallationKey key,
                 const SpoolLimits& limits);
    Result<void> readInstances();
    Result<void> checkRoom(std::size_t arriving) const;  // while the mutex is held
    bool takePatient(const Identity& patient);           // false: of another one
    std::filesystem::path fileOf(const std::string& sopInstanceUid) const;

    const std::filesystem::path folder_;
    const std::string studyInstanceUid_;
    const InstallationKey key_;
    const SpoolLimits limits_;
    ArrivingFiles arriving_;
    std::unique_ptr<Locked> locked_;
    std::function<void()> kept_;
    mutable std::mutex mutex_;
    std::set<std::string> instances_;
    std::optional<Identity> expected_;  // the patient whom the archive names
    std::optional<Identity> patient_;   // of the files
    std::uintmax_t bytes_ = 0;          // of the files
    std::atomic<std::size_t> ofOtherStudies_{0};
    std::atomic<std::size_t> unreadable_{0};
};

}  // namespace macula::study
