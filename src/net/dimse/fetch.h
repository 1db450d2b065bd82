// Fetching a study: C-GET, or C-MOVE to a receiver of ours, until all that the archive promised is there.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "net/archive/receiver.h"
#include "net/dimse/connector.h"
#include "net/dimse/contexts.h"
#include "net/dimse/find.h"
#include "net/dimse/heartbeat.h"
#include "net/dimse/incoming.h"

namespace macula::net {

class Fetch {
  public:
    Fetch(const Connector& connector, const Wanted& wanted, std::string patientId, Receiver& receiver,
          Progress& progress);

    Result<Fetched> run();

  private:
    enum class Way { get, move };

    // Asks the archive which instances it has. Where it cannot be asked, the responses tell how many there
    // are.
    Result<void> findPromised();
    Result<void> askForPromised(Finder& finder);
    Result<void> askForInstances(Finder& finder, const std::vector<FoundSeries>& series);
    bool isMissing(const std::string& sopInstanceUid) const;
    std::size_t countMissing() const;
    // What to ask for to get what is missing.
    std::vector<Keys> requests() const;
    Keys keysAt(const char* level, const std::string& series, const std::string& instances) const;
    std::vector<Keys> keysOfMissing() const;
    std::vector<ProposedContext> contexts() const;
    // Over one association.
    Result<void> attempt();
    // An archive may choose one encoding for all that it sends, and then fail with what it has in another.
    void askInOtherEncodings();
    Result<Way> wayOver(const Association& association) const;
    // Those that a person sees first.
    Result<void> requestFirst(Association& association, const AcceptedContext& context);
    Result<void> request(Association& association, const AcceptedContext& context, const Keys& keys, Way way);
    Result<void> receiveResponses(Association& association, const AcceptedContext& context,
                                  std::uint16_t messageId, Way way);
    Result<bool> takeResponse(Association& association, const AcceptedContext& context,
                              const Command& response, Way way);
    void awaitStragglers(const class MoveReceiver& receiver, std::size_t sent);
    Fetched fetched() const;

    const Connector& connector_;
    const Wanted& wanted_;
    StudyPlace study_;
    Progress& progress_;
    Incoming incoming_;
    std::map<std::string, FoundInstance> promised_;
    std::set<std::string> modalities_;
    bool isPromised_ = false;       // promised_ is what the archive says it has
    bool isListWhole_ = true;       // nothing is missing in promised_
    std::size_t told_ = 0;          // of instances, by responses
    std::size_t sentByMove_ = 0;    // as the archive counts
    std::size_t failedByMove_ = 0;  // as the archive counts
    std::optional<Error> refusal_;  // why the archive sent less than it has
    bool getFailed_ = false;        // C-GET brought nothing
    bool sendsImages_ = true;       // of a series also some: not all archives do
    std::size_t failed_ = 0;        // over the last association, as the archive counts
    Way way_ = Way::get;            // over the last association
    Encodings encodings_ = Encodings::any;
    std::shared_ptr<Heartbeat> heartbeat_;
};

}  // namespace macula::net
