// Fetches a study or some of its series over the web (QIDO-RS, then WADO-RS).
#pragma once

#include <deque>
#include <string>
#include <unordered_set>
#include <vector>

#include "net/archive/receiver.h"
#include "net/web/http_client.h"
#include "net/web/instance_sink.h"

namespace macula::net {

class WebFetch {
  public:
    // All of them must outlive it. `service`: the address under which QIDO-RS and WADO-RS answer.
    WebFetch(const std::string& service, HttpClient& client, const Wanted& wanted, Receiver& receiver,
             Progress& progress);

    Result<Fetched> run();

  private:
    // A series, and what is to be sent of it.
    struct SeriesToCome {
        std::string uid;
        std::vector<FoundInstance> instances;
        bool isListed = true;  // the archive told its instances; if not, it is asked for as a whole
        bool hasCome = false;  // one that is not listed
        std::size_t expected = 0;
    };
    struct Pull {
        HttpRequest request;
        InstanceSink sink;
        SeriesToCome* series = nullptr;
        std::string sopInstanceUid;  // empty: the series as a whole

        Pull(FetchTally& tally, InstanceKey promised, std::size_t most)
            : sink(tally, std::move(promised), most) {}
    };

    Result<void> askForInstances();
    Result<bool> askForStudyAtOnce();
    Result<void> askBySeries();
    void countPromised();
    bool isMissing(const FoundInstance& instance) const;
    bool isMissing(const SeriesToCome& series) const;  // all of it
    std::size_t missing() const;
    std::deque<Pull> pullsOfRound();
    Result<void> round();
    Result<void> judge(Pull& pull, const HttpOutcome& outcome);
    void giveUp(const Pull& pull);
    Result<void> pauseBeforeRound(int failures);

    const std::string& service_;
    HttpClient& client_;
    const Wanted& wanted_;
    Progress& progress_;
    FetchTally tally_;
    std::vector<SeriesToCome> series_;
    std::unordered_set<std::string> givenUp_;  // SOP Instance UIDs that the archive says it cannot send
    std::optional<Error> lastError_;
};

}  // namespace macula::net
