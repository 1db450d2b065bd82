#include "dicom/manifest/imaging_manifest.h"

#include <algorithm>
#include <map>
#include <new>
#include <set>
#include <string_view>
#include <utility>

#include "base/printable.h"
#include "dicom/read/values.h"

namespace macula::dicom {

namespace {

constexpr std::string_view kKeyObjectSelection = "1.2.840.10008.5.1.4.1.1.88.59";
constexpr Tag kRetrieveAeTitle{0x0008, 0x0054};
constexpr Tag kCodeValue{0x0008, 0x0100};
constexpr Tag kCodingScheme{0x0008, 0x0102};
constexpr Tag kReferencedSopClassUid{0x0008, 0x1150};
constexpr Tag kReferencedSopInstanceUid{0x0008, 0x1155};
constexpr Tag kRetrieveUrl{0x0008, 0x1190};
constexpr Tag kReferencedSops{0x0008, 0x1199};
constexpr Tag kConceptName{0x0040, 0xA043};
constexpr Tag kEvidence{0x0040, 0xA375};  // Current Requested Procedure Evidence Sequence
constexpr Tag kRetrieveLocationUid{0x0040, 0xE011};
constexpr Tag kWadoRsRetrieval{0x0040, 0xE025};

constexpr std::size_t kMostStudies = 100;
constexpr std::size_t kMostSeries = 20'000;
constexpr std::size_t kMostInstances = 200'000;
constexpr std::size_t kMostPlaces = 8;
constexpr std::size_t kMostBytesOfUrl = 2048;
constexpr std::size_t kMostBytesOfUid = 64;
constexpr std::size_t kMostBytesOfAeTitle = 16;

// Empty for what is no UID.
std::string uidOf(const Dataset& item, Tag tag) {
    std::string uid = item.shortText(tag);
    return isUid(uid) ? uid : std::string();
}

void addOnce(std::vector<std::string>& list, std::string text, std::size_t mostBytes) {
    const bool isUsable = !text.empty() && text.size() <= mostBytes && printable(text) == text;
    if (isUsable && list.size() < kMostPlaces && std::ranges::find(list, text) == list.end())
        list.push_back(std::move(text));
}

// The item itself, and what MADO keeps in a sequence of its own.
void addPlaceOf(const Dataset& item, RetrievePlace& place) {
    addOnce(place.urls, item.text(kRetrieveUrl).value_or(""), kMostBytesOfUrl);
    for (const Dataset& retrieval : item.items(kWadoRsRetrieval))
        addOnce(place.urls, retrieval.text(kRetrieveUrl).value_or(""), kMostBytesOfUrl);
    for (std::string& title : item.shortTexts(kRetrieveAeTitle))
        addOnce(place.aeTitles, std::move(title), kMostBytesOfAeTitle);
    addOnce(place.locationUids, uidOf(item, kRetrieveLocationUid), kMostBytesOfUid);
}

Error notUsable(const std::filesystem::path& path, Text message) {
    return {ErrorCode::inputNotUsable, std::move(message), path.string(),
            Text("Get the manifest again from where it was made.")};
}

// Reads the lists of a manifest, which may repeat studies and series.
class Reader {
  public:
    explicit Reader(const std::filesystem::path& path) : path_(path) {}

    Result<void> read(const Dataset& header) {
        for (const Dataset& study : header.items(kEvidence)) {
            const std::string uid = uidOf(study, tag::kStudyInstanceUid);
            if (uid.empty()) {
                ++found.unusable;
                continue;
            }
            MACULA_TRY_VOID(readStudy(study, studyOf(uid)));
        }
        std::erase_if(found.studies, [](const ManifestStudy& study) { return study.instances() == 0; });
        return {};
    }

    ImagingManifest found;

  private:
    std::size_t studyOf(const std::string& uid) {
        const auto at = std::ranges::find(found.studies, uid, &ManifestStudy::studyInstanceUid);
        if (at != found.studies.end()) return std::size_t(at - found.studies.begin());
        found.studies.push_back({uid, {}});
        return found.studies.size() - 1;
    }

    ManifestSeries& seriesOf(std::size_t study, const std::string& uid) {
        std::vector<ManifestSeries>& all = found.studies[study].series;
        const auto [place, isNew] = places_.try_emplace({study, uid}, all.size());
        if (isNew) all.push_back({uid, {}, {}});
        return all[place->second];
    }

    Result<void> readStudy(const Dataset& item, std::size_t study) {
        if (found.studies.size() > kMostStudies)
            return notUsable(path_, Text("The manifest names more than {} studies.", kMostStudies));
        for (const Dataset& each : item.items(tag::kReferencedSeries)) {
            const std::string uid = uidOf(each, tag::kSeriesInstanceUid);
            if (uid.empty()) {
                ++found.unusable;
                continue;
            }
            ManifestSeries& series = seriesOf(study, uid);
            if (places_.size() > kMostSeries)
                return notUsable(path_, Text("The manifest names more than {} series.", kMostSeries));
            addPlaceOf(each, series.place);
            addPlaceOf(item, series.place);
            MACULA_TRY_VOID(readInstances(each, series));
        }
        return {};
    }

    Result<void> readInstances(const Dataset& item, ManifestSeries& series) {
        for (const Dataset& each : item.items(kReferencedSops)) {
            const std::string uid = uidOf(each, kReferencedSopInstanceUid);
            if (uid.empty()) {
                ++found.unusable;
                continue;
            }
            if (!instances_.insert(uid).second) continue;
            if (instances_.size() > kMostInstances)
                return notUsable(path_, Text("The manifest names more than {} images.", kMostInstances));
            series.instances.push_back({uidOf(each, kReferencedSopClassUid), uid});
            addPlaceOf(each, series.place);
        }
        return {};
    }

    const std::filesystem::path& path_;
    std::map<std::pair<std::size_t, std::string>, std::size_t> places_;  // of series in their studies
    std::set<std::string> instances_;
};

}  // namespace

std::size_t ManifestStudy::instances() const {
    std::size_t count = 0;
    for (const ManifestSeries& each : series) count += each.instances.size();
    return count;
}

Text imagingManifestKind() {
    return Text("Imaging manifest");
}

bool isImagingManifest(const Dataset& header) {
    if (header.shortText(tag::kSopClassUid) != kKeyObjectSelection) return false;
    const std::vector<Dataset> titles = header.items(kConceptName);
    if (titles.empty()) return false;
    const std::string code = titles.front().shortText(kCodeValue);
    const std::string scheme = titles.front().shortText(kCodingScheme);
    // Manifest, and Manifest with Description (PS3.16 CID 7010), which trial implementations code otherwise.
    return (scheme == "DCM" && (code == "113030" || code == "131560")) ||
           (scheme == "99IHE" && code == "MADOTEMP001");
}

Result<ImagingManifest> readImagingManifest(const std::filesystem::path& path) try {
    const HeaderFile file = readHeader(path);
    if (file.state == FileState::unreadable)
        return Error{ErrorCode::inputNotUsable, Text("The file cannot be read."), path.string(),
                     Text("Check the path and its permissions.")};
    if (!file.header || !isImagingManifest(*file.header))
        return Error{
            ErrorCode::inputNotUsable, Text("The file is no imaging manifest."), path.string(),
            Text("Choose a DICOM Key Object Selection whose title is Manifest, as IHE MADO defines it.")};
    const Dataset& header = *file.header;
    Reader reader(path);
    MACULA_TRY_VOID(reader.read(header));
    ImagingManifest& found = reader.found;
    if (found.studies.empty()) return notUsable(path, Text("The manifest names no images."));
    found.patientName = header.text(tag::kPatientName).value_or("");
    found.patient = patientIdentity(header);
    found.studyDate = header.shortText(tag::kStudyDate);
    found.studyDescription = header.text(tag::kStudyDescription).value_or("");
    return std::move(found);
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory, Text("There is not enough memory for the manifest."), path.string(),
                 Text("Close other programs.")};
}

}  // namespace macula::dicom
