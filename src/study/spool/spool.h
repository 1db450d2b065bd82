// The private place of studies that were fetched from archives (docs/privacy.md).
//
// A folder for each study, 0700, in which each instance is a file, 0600, as the archive sent it. Names are
// keyed digests of UIDs. A file gets its name once it is whole, so whatever kills the program leaves a spool
// that opens; what was half there is removed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/installation_key.h"
#include "base/result.h"
#include "study/spool/spool_limits.h"
#include "study/spool/spooled_study.h"

namespace macula::study {

// What the spool has of a study.
struct SpoolEntry {
    std::filesystem::path folder;
    SpoolRecord record;
    std::size_t instances = 0;
    std::uintmax_t bytes = 0;
    std::filesystem::file_time_type used{};  // last fetched, or opened (touch)
};

// The record of a folder of the user's spool, of which it notes that it is used; nothing for other folders.
std::optional<SpoolRecord> useSpooled(const std::filesystem::path& folder);

// The user's: fetched, in the data folder.
std::filesystem::path spoolFolder();

class Spool {
  public:
    // The user's private folder. Makes it if it is missing. Fails with outputNotWritable.
    static Result<Spool> open(const std::filesystem::path& folder = spoolFolder(), SpoolLimits limits = {});
    // A folder that a person chose: its permissions stay, and nothing in it is ever removed.
    static Result<Spool> chosen(const std::filesystem::path& folder);

    const std::filesystem::path& folder() const { return folder_; }
    const SpoolLimits& limits() const { return limits_; }

    // Studies whose record can be read, those used last first.
    std::vector<SpoolEntry> entries() const;

    // To fetch the study into. Several threads may ask at once.
    Result<std::unique_ptr<SpooledStudy>> study(const std::string& studyInstanceUid,
                                                const CancelToken& cancel = {});
    // Where the study lies or would lie.
    std::filesystem::path folderOf(const std::string& studyInstanceUid) const;

    // Removes studies until `mostBytes` are kept, those used longest ago first, none that is being fetched,
    // and none that this spool has given out. Returns how many. `fetched`: counts and removes only those that
    // came from an archive.
    enum class Purged { fetched, all };
    Result<std::size_t> purge(std::uintmax_t mostBytes, Purged which = Purged::all);
    // By itself, to make room.
    Result<std::size_t> purge() {
        return isChosen_ ? Result<std::size_t>(std::size_t(0)) : purge(limits_.mostBytes, Purged::fetched);
    }

  private:
    Spool(std::filesystem::path folder, InstallationKey key, SpoolLimits limits)
        : folder_(std::move(folder)), key_(key), limits_(limits) {}

    std::filesystem::path folder_;
    InstallationKey key_;
    SpoolLimits limits_;
    bool isChosen_ = false;
    struct Given {
        std::mutex mutex;
        std::set<std::filesystem::path> folders;
    };
    std::shared_ptr<Given> given_ = std::make_shared<Given>();  // of studies that were fetched into
};

}  // namespace macula::study
