#include "live/store/study_keeper.h"

#include <future>
#include <utility>

#include "live/store/seen_before.h"

namespace macula::live {

StudyKeeper::StudyKeeper(session::StoreOptions options, KeeperListener listener,
                         std::optional<std::chrono::days> retention)
    : messages_(std::move(listener)),
      thread_(std::move(options), retention, messages_),
      opened_(messages_),
      models_(thread_, messages_, opened_, digests_),
      states_(thread_, messages_, opened_, digests_) {
    thread_.start([this] { models_.doWithoutStore(); });
}

StudyKeeper::~StudyKeeper() {
    thread_.finish();
}

void StudyKeeper::willShow(const std::string& name, std::shared_ptr<const Volume> volume,
                           const scene::Drawing& drawing) {
    models_.willShow(name, std::move(volume), drawing);
}

hybrid::StoredModel StudyKeeper::find(const std::string& name) {
    return models_.find(name);
}

void StudyKeeper::keep(std::shared_ptr<const hybrid::PeripheralState> state) {
    models_.keep(std::move(state));
}

bool StudyKeeper::waitUntilStatesAreKept(std::chrono::milliseconds patience) {
    auto kept = std::make_shared<std::promise<void>>();
    const auto future = kept->get_future();
    withStore([kept](session::Store*) { kept->set_value(); });
    return future.wait_for(patience) == std::future_status::ready;
}

void StudyKeeper::askWhatWasSeen(std::shared_ptr<const study::FoundVolumes> found,
                                 std::function<void(std::set<std::size_t>)> answer) {
    thread_.post(StoreThread::Urgency::isWaitedFor,
                 [this, found = std::move(found), answer = std::move(answer)](session::Store& store) {
                     if (const auto seen = volumesSeenBefore(store, *found))
                         return answer(*seen);
                     else
                         messages_.tell(seen.error());
                 });
}

}  // namespace macula::live
