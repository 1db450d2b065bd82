#include "dicom/split/join.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace macula::dicom {

namespace {

constexpr std::size_t kLeastImages = 3;

bool isPlacedImage(const Examination& e) {
    return e.state == FileState::complete && e.kind == Examination::Kind::image && e.frames.size() == 1 &&
           e.frames.front().plane;
}

auto seriesOf(const Examination& e) {
    return std::tie(e.patient, e.studyInstanceUid, e.seriesInstanceUid);
}

// The attributes in which images of one series agree.
auto descriptionOf(const Examination& e) {
    const Instance& instance = *e.frames.front().instance;
    return std::tuple(e.modality, e.seriesNumber, e.seriesDescription, instance.sopClassUid, instance.columns,
                      instance.rows);
}

bool isEvenStack(const std::vector<Examination>& found, const std::vector<std::size_t>& images) {
    std::vector<StackedPlane> planes;
    for (const std::size_t i : images) planes.push_back({*found[i].frames.front().plane});
    const StackGeometry geometry = stackPlanes(planes);
    return geometry.quality != StackGeometry::Quality::none &&
           std::none_of(geometry.messages.begin(), geometry.messages.end(),
                        [](const Message& m) { return m.key == key::kIrregularSpacing; });
}

// The levels whose identifiers differ. Empty when an identifier is neither one for all nor one for each.
Text levelsOf(const std::vector<Examination>& found, const std::vector<std::size_t>& images) {
    std::set<PatientIdentity> patients;
    std::set<std::string_view> studies;
    std::set<std::string_view> series;
    for (const std::size_t i : images) {
        patients.insert(found[i].patient);
        studies.insert(found[i].studyInstanceUid);
        series.insert(found[i].seriesInstanceUid);
    }
    Text levels;
    for (const auto& [count, name] :
         {std::pair(patients.size(), Text("patient")), std::pair(studies.size(), Text("study")),
          std::pair(series.size(), Text("series"))}) {
        if (count == 1) continue;
        if (count != images.size()) return {};
        levels = levels.empty() ? name : Text("{} and {}", std::move(levels), name);
    }
    return levels;
}

}  // namespace

std::vector<Scattered> findScattered(const std::vector<Examination>& found) {
    using Identity = std::tuple<PatientIdentity, std::string, std::string>;
    std::map<Identity, std::size_t> files;
    for (const Examination& e : found) {
        if (e.state == FileState::complete && e.kind == Examination::Kind::image)
            ++files[Identity(seriesOf(e))];
    }
    using Description = decltype(descriptionOf(found.front()));
    std::map<Description, std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (isPlacedImage(found[i]) && files[Identity(seriesOf(found[i]))] == 1)
            groups[descriptionOf(found[i])].push_back(i);
    }
    std::vector<Scattered> all;
    for (auto& [description, images] : groups) {
        if (images.size() < kLeastImages) continue;
        Text levels = levelsOf(found, images);
        if (levels.empty() || !isEvenStack(found, images)) continue;
        all.push_back({std::move(images), std::move(levels)});
    }
    return all;
}

void join(std::vector<Examination>& found, const Scattered& scattered) {
    const Examination& first = found[scattered.images.front()];
    for (const std::size_t i : scattered.images) {
        Examination& e = found[i];
        e.patient = first.patient;
        e.patientName = first.patientName;
        e.studyInstanceUid = first.studyInstanceUid;
        e.studyDate = first.studyDate;
        e.studyDescription = first.studyDescription;
        e.seriesInstanceUid = first.seriesInstanceUid;
    }
}

}  // namespace macula::dicom
