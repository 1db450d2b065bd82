#include "viewer/receive/reception.h"

#include <chrono>
#include <mutex>
#include <thread>
#include <utility>

namespace macula::viewer {

namespace {

constexpr std::chrono::milliseconds kLookedAtEvery{100};

// Told by the threads that serve.
class TurnedAwayLast {
  public:
    void note(const net::TurnedAway& each) {
        const std::lock_guard lock(mutex_);
        ++count_;
        why_ = textOf(each);
    }
    void addTo(ReceptionNews& news) const {
        const std::lock_guard lock(mutex_);
        news.turnedAway = count_;
        news.whyTurnedAway = why_;
    }

  private:
    mutable std::mutex mutex_;
    std::size_t count_ = 0;
    std::optional<Text> why_;
};

Error notAllKept() {
    return {ErrorCode::outputNotWritable,
            Text("Not all that was sent was kept. Its sender knows it."),
            {},
            Text("Make room, or allow more in Settings, Receiving; then have it sent again.")};
}

}  // namespace

Result<ReceptionEnd> receiveUntilStopped(study::ReceivingOptions options, const CancelToken& stop,
                                         const Progress& progress,
                                         const std::function<void(const ReceptionNews&)>& tell) {
    TurnedAwayLast turnedAway;
    options.provider.onTurnedAway = [&](const net::TurnedAway& each) { turnedAway.note(each); };
    MACULA_TRY(const auto receiving, study::Receiving::start(options));
    study::ReceivedStudies& studies = receiving->studies();
    ReceptionNews before{.port = receiving->port(), .arriving = {}, .done = {}, .trouble = {}};
    tell(before);
    ReceptionEnd end;
    const auto look = [&](std::vector<study::ReceivedStudy> done) {
        ReceptionNews news{.port = before.port,
                           .arriving = studies.arriving(),
                           .done = std::move(done),
                           .trouble = studies.takeTrouble()};
        turnedAway.addTo(news);
        const net::StoreProvider::Counts counts = receiving->counts();
        news.refused = counts.refused;
        news.withoutRoom = counts.withoutRoom;
        if (news.withoutRoom > before.withoutRoom && !news.trouble) news.trouble = notAllKept();
        end.studies += news.done.size();
        const bool isNew = news.arriving != before.arriving || !news.done.empty() || news.trouble ||
                           news.turnedAway != before.turnedAway || news.refused != before.refused;
        if (isNew) tell(news);
        before = std::move(news);
    };
    while (!stop.cancelled() && !progress.cancelled()) {
        std::this_thread::sleep_for(kLookedAtEvery);
        look(studies.finishQuiet());
    }
    receiving->end();
    look(studies.finishAll());
    return end;
}

}  // namespace macula::viewer
