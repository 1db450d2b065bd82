#include "live/store/study_keeper.h"

#include <future>
#include <map>
#include <utility>

#include "session/model_key.h"

namespace macula::live {

namespace {

// Which volumes of a folder were opened before, as indices into FoundVolumes::volumes(). A volume's digest is
// unknown until its voxels are read, so the volumes of a series count as seen only once as many were opened
// as the series has. Waits for the disk.
Result<std::set<std::size_t>> volumesSeenBefore(session::Store& store, const study::FoundVolumes& found) {
    std::map<const dicom::Series*, std::size_t> volumesOf;
    for (const study::FoundVolume& volume : found.volumes()) ++volumesOf[volume.series];
    std::map<std::string, std::size_t> opened;  // volumes, by the identity of the series
    std::set<std::string> asked;                // studies
    std::set<std::size_t> seen;
    for (std::size_t i = 0; i < found.volumes().size(); ++i) {
        const dicom::Series& series = *found.volumes()[i].series;
        if (series.studyInstanceUid.empty() || series.seriesInstanceUid.empty()) continue;
        const std::string study = session::studyIdentity(series.studyInstanceUid);
        if (asked.insert(study).second) {
            MACULA_TRY(const session::Listing<session::SeriesEntry> known, store.listSeries(study));
            for (const session::SeriesEntry& entry : known.entries)
                opened[entry.identity] = entry.volumes.size();
        }
        const auto known =
            opened.find(session::seriesIdentity(series.studyInstanceUid, series.seriesInstanceUid));
        if (known != opened.end() && known->second >= volumesOf[&series]) seen.insert(i);
    }
    return seen;
}

}  // namespace

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
