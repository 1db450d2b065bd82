// An archive: what every protocol offers.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "net/archive/commitment.h"
#include "net/archive/query.h"
#include "net/archive/receiver.h"
#include "net/archive/source.h"

namespace macula::net {

// A step of a test of a source, in the order in which a connection is made: name, port, TLS, AE titles or
// sign-in, search, retrieval.
struct TestStep {
    Text name;
    bool passed = false;
    Text detail;  // what was found, or why it failed
    Text advice;  // what to do; empty if it passed
};

// An instance that is not stored.
struct NotSent {
    std::filesystem::path file;
    Text why;
    Text advice;
    // The archive said no, or the file cannot be sent as it is; otherwise the archive gave no answer to it.
    bool isRefused = true;
};

struct Sent {
    std::size_t stored = 0;
    std::vector<NotSent> notSent;
};

// Every call connects by itself, blocks, may be made from any thread and by several at once. Cancelling tells
// the peer so (C-CANCEL, or the connection is closed) and ends within a second of the peer's next byte, or
// five seconds. Errors: archiveNotUsable with what to do; usage for a malformed date or UID of a query;
// cancelled; what the receiver returns. No text of them holds an identifier.
class Archive {
  public:
    virtual ~Archive() = default;

    virtual Result<StudyAnswers> findStudies(const StudyQuery& query, Progress& progress) = 0;
    virtual Result<std::vector<FoundSeries>> findSeries(const std::string& studyInstanceUid,
                                                        Progress& progress) = 0;
    // Of one series, or of the whole study if `seriesInstanceUid` is empty.
    virtual Result<std::vector<FoundInstance>> findInstances(const std::string& studyInstanceUid,
                                                             const std::string& seriesInstanceUid,
                                                             Progress& progress) = 0;

    // A connection that breaks is made again, three times without an instance in between, and goes on with
    // what is missing. What was received stays, whatever the result.
    virtual Result<Fetched> fetch(const Wanted& wanted, Receiver& receiver, Progress& progress) = 0;

    // Files of PS3.10, unchanged.
    virtual Result<Sent> send(std::span<const std::filesystem::path> files, Progress& progress) = 0;

    // Asks the archive to confirm that it keeps files that were stored, and waits for its reports, which may
    // come over a connection that the archive makes to our receiver. One result for each file, in their
    // order. Fails with archiveNotUsable where the archive does not offer it.
    virtual Result<std::vector<Commitment>> commit(std::span<const std::filesystem::path> /*files*/,
                                                   std::chrono::seconds /*patience*/,
                                                   Progress& /*progress*/) {
        return commitmentNotOffered();
    }

    // Never fails: the last step says what did. Steps behind one that failed are not tried.
    virtual std::vector<TestStep> test(Progress& progress) = 0;
};

}  // namespace macula::net
