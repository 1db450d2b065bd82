// Instances as an archive sends them, by C-GET or to our receiver.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>

#include "base/progress.h"
#include "base/result.h"
#include "net/archive/receiver.h"
#include "net/dimse/messages.h"

namespace macula::net {

// Writes instances where the receiver says, and counts what becomes of them. Thread-safe.
class Incoming {
  public:
    Incoming(const Wanted& wanted, Receiver& receiver, Progress& progress);

    // The instances that the archive says it has, by SOP Instance UID.
    void expect(const std::map<std::string, FoundInstance>& promised);

    // Receives the dataset of a C-STORE request, and answers. An error means that the association is of no
    // more use; hasFailed() tells whether the fetch is over too.
    Result<void> store(Association& association, const ReceivedCommand& request);

    // The receiver's own error.
    std::optional<Error> failure() const;
    // Those decided on: taken, had, or refused.
    bool isSettled(const std::string& sopInstanceUid) const;
    // How often something new came that was not refused without having been promised.
    std::size_t steps() const;
    Fetched counts() const;
    std::size_t distinct() const;                             // instances taken or refused, each once
    bool cameAgain(const std::string& sopInstanceUid) const;  // although it was there
    std::size_t arrived() const;                              // stored or refused, over all

  private:
    enum class Outcome { kept, hadAlready, refused };
    struct Stored {
        std::optional<Outcome> outcome;  // empty: it did not come whole, or could not be written
        std::optional<Error> end;        // of the association
    };

    Stored write(Association& association, const ReceivedCommand& request);
    Stored take(const std::filesystem::path& file, const Command& command);
    Stored fail(const Error& error);
    bool isTooMuch() const;
    void count(const std::string& sopInstanceUid, Outcome outcome);

    const Wanted& wanted_;
    Receiver& receiver_;
    Progress& progress_;
    mutable std::mutex mutex_;
    std::map<std::string, FoundInstance> promised_;
    std::set<std::string> taken_;
    std::set<std::string> refused_;
    std::set<std::string> had_;  // of those taken: came although they were there
    std::optional<Error> failure_;
    Fetched counts_;
    std::size_t steps_ = 0;
    std::size_t arrived_ = 0;
};

}  // namespace macula::net
