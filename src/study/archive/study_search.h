// One search over archives and this machine.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "net/archive/archive.h"
#include "net/archive/query.h"

namespace macula::study {

// Names a patient: for the screen only.
struct ListedStudy {
    net::FoundStudy study;
    std::string archive;           // that has it; empty: it is on this machine alone
    std::filesystem::path folder;  // where it lies on this machine; empty: it must be fetched
    bool isWhole = false;          // in the folder
};

struct SilentArchive {
    std::string name;
    Error why;
};

struct Listing {
    // Those of the archives come first, in the archives' order, then those of this machine alone. A study
    // that was fetched from an archive is listed once.
    std::vector<ListedStudy> studies;
    std::vector<SilentArchive> silent;
    bool isCutShort = false;   // an archive has more
    std::size_t unusable = 0;  // answers without a valid Study Instance UID
};

struct NamedArchive {
    std::string name;
    Result<std::shared_ptr<net::Archive>> archive;  // an error: why it cannot be asked
};

struct PlacesToSearch {
    std::vector<NamedArchive> archives;
    bool isHereToo = false;                      // this machine: fetched studies, and those in `folders`
    std::vector<std::filesystem::path> folders;  // with folders below them
};

// Told what was found so far, by the threads that search, one at a time.
using ListingListener = std::function<void(const Listing&)>;

// Asks all places at once. One that does not answer holds up no other, and is listed as silent. After a
// cancellation it returns what it has.
Listing searchStudies(const PlacesToSearch& places, const net::StudyQuery& query, Progress& progress,
                      const ListingListener& listener = {});

// With what is on this machine now of fetched studies and of those that others sent, as the search for
// `query` has it that looks on this machine too. Asks no archive.
Listing withStudiesHere(Listing listing, const net::StudyQuery& query, const CancelToken& cancel = {});

}  // namespace macula::study
