#include "dicom/read/directory_records.h"

#include <map>

#include "dicom/read/tags.h"

namespace macula::dicom {

namespace {

constexpr Tag kNextRecord{0x0004, 0x1400};
constexpr Tag kRecordInUse{0x0004, 0x1410};
constexpr Tag kLowerLevel{0x0004, 0x1420};
constexpr Tag kRecordType{0x0004, 0x1430};
constexpr Tag kReferencedFile{0x0004, 0x1500};
constexpr Tag kReferencedInstance{0x0004, 0x1511};

std::uint64_t offsetIn(const Dataset& record, Tag tag) {
    return static_cast<std::uint64_t>(record.number(tag).value_or(0.0));
}

bool isSeries(const Dataset& record) {
    return record.shortText(kRecordType) == "SERIES";
}

// The series of each record; an empty UID where there is none.
std::vector<std::string> seriesOf(const std::vector<Dataset>& records) {
    std::map<std::uint64_t, std::size_t> byOffset;
    for (std::size_t i = 0; i < records.size(); ++i) byOffset.emplace(records[i].offset(), i);
    std::vector<std::string> series(records.size());
    std::vector<bool> isFound(records.size(), false);
    for (const Dataset& record : records) {
        if (!isSeries(record)) continue;
        const std::string uid = record.shortText(tag::kSeriesInstanceUid);
        // No record is visited twice, so that rings end.
        for (auto at = byOffset.find(offsetIn(record, kLowerLevel));
             at != byOffset.end() && !isFound[at->second];
             at = byOffset.find(offsetIn(records[at->second], kNextRecord))) {
            isFound[at->second] = true;
            series[at->second] = uid;
        }
    }
    std::string before;
    for (std::size_t i = 0; i < records.size(); ++i) {
        const std::string type = records[i].shortText(kRecordType);
        if (type == "PATIENT" || type == "STUDY") before.clear();
        if (type == "SERIES") before = records[i].shortText(tag::kSeriesInstanceUid);
        if (!isFound[i]) series[i] = before;
    }
    return series;
}

}  // namespace

std::vector<DirectoryRecord> directoryRecords(const Dataset& directory) {
    constexpr std::uint16_t kNotInUse = 0;
    const std::vector<Dataset> all = directory.items(tag::kDirectoryRecords);
    const std::vector<std::string> series = seriesOf(all);
    std::vector<DirectoryRecord> records;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].word(kRecordInUse) == kNotInUse) continue;
        auto fileId = all[i].texts(kReferencedFile);
        if (fileId.empty()) continue;
        records.push_back({.fileId = std::move(fileId),
                           .sopInstanceUid = all[i].shortText(kReferencedInstance),
                           .seriesInstanceUid = series[i],
                           .instanceNumber = all[i].integer(tag::kInstanceNumber)});
    }
    return records;
}

}  // namespace macula::dicom
