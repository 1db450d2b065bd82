// Notices studies that appear in a folder: from a modality, a disc that is copied, another program.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "dicom/read/folder.h"
#include "study/open/identity.h"

namespace macula::study {

struct FolderIdentity {
    std::uintmax_t device = 0;
    std::uintmax_t number = 0;

    bool operator==(const FolderIdentity&) const = default;
};

struct ArrivedStudy {
    std::filesystem::path folder;  // that is watched
    std::filesystem::path file;    // of the study: an image if it has one
    Identity identity;
    std::set<std::string> modalities;
    std::size_t images = 0;  // files that came
    std::string sender =
        {};  // who sent it to this program, as it says itself; empty: it appeared in the folder
};

// Looks at names, sizes and times of the files, which also works where a network file system tells nobody of
// changes, and reads a file only after it has not changed for a while. What is there at the first look is
// known, as is what comes while the folder is not there. One thread at a time.
class WatchedFolder {
  public:
    using Clock = std::chrono::steady_clock;

    // `quiet`: how long nothing of a study may change before it is told.
    WatchedFolder(std::filesystem::path folder, std::chrono::milliseconds quiet)
        : folder_(std::move(folder)), quiet_(quiet) {}

    const std::filesystem::path& folder() const { return folder_; }

    // The studies that are whole since the last look, as far as one can tell: each once, and again if more of
    // it comes later. Fails as dicom::listFiles; the next look goes on. `now` never goes back.
    Result<std::vector<ArrivedStudy>> look(Clock::time_point now, Progress& progress);

  private:
    struct File {
        std::uintmax_t bytes = 0;
        std::filesystem::file_time_type written;
        Clock::time_point changed;  // by our clock: that of a file server may be another
        bool isKnown = false;       // it was there before, or has been read
    };
    struct Arriving {
        ArrivedStudy study;
        Clock::time_point changed;
        std::set<std::filesystem::path> folders;
    };

    void note(const dicom::FolderListing& listing, Clock::time_point now, bool areKnown);
    void read(Clock::time_point now, const Progress& progress);
    std::vector<ArrivedStudy> takeWhole(Clock::time_point now);

    std::filesystem::path folder_;
    std::chrono::milliseconds quiet_;
    std::optional<FolderIdentity> identity_;
    std::map<std::filesystem::path, File> files_;
    std::map<std::string, Arriving> arriving_;  // by Study Instance UID
};

}  // namespace macula::study
