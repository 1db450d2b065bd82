#include "live/store/opened_record.h"

#include <utility>

namespace macula::live {

session::OpenedVolume openedVolume(const Volume& volume, std::string digest) {
    const Provenance& from = volume.provenance();
    session::OpenedVolume opened{.study = {}, .series = {}, .volume = std::move(digest)};
    if (from.studyInstanceUid.empty() || from.seriesInstanceUid.empty()) return opened;
    opened.study = session::studyIdentity(from.studyInstanceUid);
    opened.series = session::seriesIdentity(from.studyInstanceUid, from.seriesInstanceUid);
    return opened;
}

void OpenedRecord::record(session::Store& store, const session::OpenedVolume& volume) {
    if (recorded_.contains(volume.volume)) return;
    if (const auto done = store.recordOpened(volume); !done) return messages_.tell(done.error());
    recorded_.insert(volume.volume);
}

}  // namespace macula::live
