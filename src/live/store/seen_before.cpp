#include "live/store/seen_before.h"

#include <map>
#include <string>

#include "session/model_key.h"

namespace macula::live {

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

}  // namespace macula::live
