// Where instances go as they arrive from an archive.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "base/result.h"
#include "net/archive/query.h"

namespace macula::net {

// As the archive names an instance. A field is empty where the protocol does not say it before the file is
// there. Nothing of it may be used in a path: a hostile archive chooses it.
struct InstanceKey {
    std::string studyInstanceUid;
    std::string seriesInstanceUid;
    std::string sopClassUid;
    std::string sopInstanceUid;
};

// Called from several threads at once. An error of either function ends the fetch with that error: the disk
// is full, or a quota is reached. Whoever writes a file leaves the dataset as it came, bit for bit, behind
// file meta information of PS3.10.
class Receiver {
  public:
    virtual ~Receiver() = default;

    // A new, empty file, readable by its owner only, in which an instance is to be written.
    virtual Result<std::filesystem::path> place() = 0;

    enum class Verdict {
        kept,
        hadAlready,  // the same instance, which had come before
        refused,     // it is not what was asked for, or no DICOM that could be opened
    };
    // The file is complete. Whatever the verdict, it belongs to the receiver now.
    virtual Result<Verdict> take(const std::filesystem::path& file, const InstanceKey& promised) = 0;

    // Writing ended early; the file goes.
    virtual void drop(const std::filesystem::path& file) noexcept = 0;

    // The most bytes that one instance may have; whoever writes stops there, drops it, and counts it as
    // refused.
    virtual std::uintmax_t mostBytesOfInstance() const = 0;
};

// What to fetch: a study, or some of its series, without the instances that are there already.
struct Wanted {
    std::string studyInstanceUid;
    std::vector<std::string> seriesInstanceUids;  // empty: all
    std::set<std::string> sopInstancesHad;
};

struct Fetched {
    std::size_t promised = 0;  // instances that the archive says it has, those had already included
    std::size_t kept = 0;
    std::size_t hadAlready = 0;        // skipped, or sent again
    std::size_t refused = 0;           // by the receiver, or too large
    std::vector<FoundInstance> never;  // promised, and not sent: after all tries
    std::size_t bytes = 0;             // received
    // The archive said which instances it has, and that list was not cut; otherwise `promised` may be too
    // small.
    bool isListWhole = true;
};

}  // namespace macula::net
