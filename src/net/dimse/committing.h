// Asks an archive to confirm that it keeps what was stored, and hears its reports: over the association that
// asked, or over one that the archive makes to our receiver, at once or minutes later.
#pragma once

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "net/archive/commitment.h"
#include "net/dimse/acceptor.h"
#include "net/dimse/commitment_dataset.h"
#include "net/dimse/connector.h"
#include "net/dimse/heartbeat.h"
#include "net/dimse/messages.h"

namespace macula::net {

class Committing {
  public:
    Committing(const Connector& connector, std::span<const std::filesystem::path> files,
               std::chrono::seconds patience, Progress& progress);

    Result<std::vector<Commitment>> run();

  private:
    using Clock = std::chrono::steady_clock;
    // Some of the instances, about which the archive is asked, and reports, together.
    struct Transaction {
        std::vector<ReferencedInstance> instances;
        bool isReported = false;
    };

    void readFiles();
    Result<void> makeTransactions();
    Result<std::unique_ptr<Acceptor>> listen();
    void serve(std::unique_ptr<Wire> wire);
    // In a thread of its own, as both ways of reporting are open at once.
    void askAndHear();
    Result<void> ask(Association& association);
    // An answer to the request, or a report that overtakes it.
    Result<void> awaitAnswer(Association& association, std::uint16_t messageId);
    bool takeReport(Association& association, const ReceivedCommand& request);
    bool note(const CommitmentReport& report);
    bool isOver() const;  // while the mutex is held
    Result<void> wait(bool listens);

    const Connector& connector_;
    const std::chrono::seconds patience_;
    Progress& progress_;
    std::vector<Commitment> results_;                         // in the order of the files
    std::map<std::string, std::vector<std::size_t>> places_;  // in results_, by SOP Instance UID
    std::vector<ReferencedInstance> instances_;               // each once
    std::map<std::string, Transaction> transactions_;         // by UID; the map itself stays as it is
    std::shared_ptr<Heartbeat> heartbeat_;
    CancelToken stopHearing_;
    CancelToken stopListening_;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::optional<Result<void>> asked_;  // how asking ended
    std::optional<Clock::time_point> askedAt_;
    bool hasEndedHearing_ = false;
};

}  // namespace macula::net
