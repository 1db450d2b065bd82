#include "net/web/qido_answers.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <unordered_set>

#include "base/parsing.h"
#include "net/archive/file_meta.h"
#include "net/web/dicom_json.h"

namespace macula::net {

namespace {

constexpr std::size_t kMostAnswersOfPage = 200'000;

namespace qido {
constexpr std::uint32_t kSopClassUid = 0x00080016;
constexpr std::uint32_t kSopInstanceUid = 0x00080018;
constexpr std::uint32_t kStudyDate = 0x00080020;
constexpr std::uint32_t kStudyTime = 0x00080030;
constexpr std::uint32_t kAccessionNumber = 0x00080050;
constexpr std::uint32_t kModality = 0x00080060;
constexpr std::uint32_t kModalitiesInStudy = 0x00080061;
constexpr std::uint32_t kReferringPhysician = 0x00080090;
constexpr std::uint32_t kStudyDescription = 0x00081030;
constexpr std::uint32_t kSeriesDescription = 0x0008103E;
constexpr std::uint32_t kPatientName = 0x00100010;
constexpr std::uint32_t kPatientId = 0x00100020;
constexpr std::uint32_t kPatientBirthDate = 0x00100030;
constexpr std::uint32_t kPatientSex = 0x00100040;
constexpr std::uint32_t kBodyPart = 0x00180015;
constexpr std::uint32_t kStudyInstanceUid = 0x0020000D;
constexpr std::uint32_t kSeriesInstanceUid = 0x0020000E;
constexpr std::uint32_t kStudyId = 0x00200010;
constexpr std::uint32_t kSeriesNumber = 0x00200011;
constexpr std::uint32_t kInstanceNumber = 0x00200013;
constexpr std::uint32_t kSeriesOfStudy = 0x00201206;
constexpr std::uint32_t kInstancesOfStudy = 0x00201208;
constexpr std::uint32_t kInstancesOfSeries = 0x00201209;
}  // namespace qido

constexpr std::array kOfStudy{qido::kStudyDate,         qido::kStudyTime,          qido::kAccessionNumber,
                              qido::kModalitiesInStudy, qido::kReferringPhysician, qido::kStudyDescription,
                              qido::kPatientName,       qido::kPatientId,          qido::kPatientBirthDate,
                              qido::kPatientSex,        qido::kStudyInstanceUid,   qido::kStudyId,
                              qido::kSeriesOfStudy,     qido::kInstancesOfStudy};
constexpr std::array kOfSeries{qido::kModality,          qido::kSeriesDescription, qido::kBodyPart,
                               qido::kSeriesInstanceUid, qido::kSeriesNumber,      qido::kInstancesOfSeries};
constexpr std::array kOfInstance{qido::kSopClassUid, qido::kSopInstanceUid, qido::kSeriesInstanceUid,
                                 qido::kInstanceNumber};

// Of an IS, which archives write as a number, as text, or as a number with a fraction.
template <class Integer>
std::optional<Integer> integerOf(const JsonDataset& dataset, std::uint32_t tag) {
    const auto number = finiteNumber(dataset.first(tag));
    const bool fits = number && std::trunc(*number) == *number &&
                      *number >= static_cast<double>(std::numeric_limits<int>::min()) &&
                      *number <= static_cast<double>(std::numeric_limits<int>::max());
    if (!fits || (*number < 0 && !std::numeric_limits<Integer>::is_signed)) return {};
    return static_cast<Integer>(*number);
}

std::vector<std::string> modalitiesOf(const JsonDataset& dataset) {
    std::vector<std::string> modalities;
    for (std::string_view value : dataset.values(qido::kModalitiesInStudy)) {
        while (!value.empty()) {
            const std::size_t end = std::min(value.find('\\'), value.size());
            if (const auto one = trimmed(value.substr(0, end)); !one.empty()) modalities.emplace_back(one);
            value.remove_prefix(std::min(end + 1, value.size()));
        }
    }
    return modalities;
}

FoundStudy studyOf(const JsonDataset& dataset) {
    FoundStudy study;
    study.studyInstanceUid = dataset.first(qido::kStudyInstanceUid);
    study.date = dataset.first(qido::kStudyDate);
    study.time = dataset.first(qido::kStudyTime);
    study.description = dataset.first(qido::kStudyDescription);
    study.accessionNumber = dataset.first(qido::kAccessionNumber);
    study.studyId = dataset.first(qido::kStudyId);
    study.patientName = dataset.first(qido::kPatientName);
    study.patientId = dataset.first(qido::kPatientId);
    study.patientBirthDate = dataset.first(qido::kPatientBirthDate);
    study.patientSex = dataset.first(qido::kPatientSex);
    study.referringPhysician = dataset.first(qido::kReferringPhysician);
    study.modalities = modalitiesOf(dataset);
    study.seriesCount = integerOf<std::size_t>(dataset, qido::kSeriesOfStudy);
    study.instanceCount = integerOf<std::size_t>(dataset, qido::kInstancesOfStudy);
    return study;
}

FoundSeries seriesOf(const JsonDataset& dataset) {
    FoundSeries series;
    series.seriesInstanceUid = dataset.first(qido::kSeriesInstanceUid);
    series.number = integerOf<int>(dataset, qido::kSeriesNumber);
    series.modality = dataset.first(qido::kModality);
    series.description = dataset.first(qido::kSeriesDescription);
    series.bodyPart = dataset.first(qido::kBodyPart);
    series.instanceCount = integerOf<std::size_t>(dataset, qido::kInstancesOfSeries);
    return series;
}

FoundInstance instanceOf(const JsonDataset& dataset) {
    FoundInstance instance;
    instance.sopInstanceUid = dataset.first(qido::kSopInstanceUid);
    if (auto uid = dataset.first(qido::kSopClassUid); isUid(uid)) instance.sopClassUid = std::move(uid);
    if (auto uid = dataset.first(qido::kSeriesInstanceUid); isUid(uid))
        instance.seriesInstanceUid = std::move(uid);
    instance.number = integerOf<int>(dataset, qido::kInstanceNumber);
    return instance;
}

template <class Found>
Result<QidoPage<Found>> pageOf(std::string_view text, std::span<const std::uint32_t> wanted,
                               Found (*foundOf)(const JsonDataset&), std::string Found::*uid) {
    QidoPage<Found> page;
    if (trimmed(text).empty()) return page;
    MACULA_TRY(const auto datasets, dicomJsonOf(text, wanted, kMostAnswersOfPage));
    page.datasets = datasets.size();
    std::unordered_set<std::string> seen;
    for (const JsonDataset& dataset : datasets) {
        Found found = foundOf(dataset);
        if (!isUid(found.*uid)) {
            ++page.unusable;
        } else if (seen.insert(found.*uid).second) {
            page.found.push_back(std::move(found));
        }
    }
    return page;
}

}  // namespace

Result<QidoPage<FoundStudy>> studiesInJson(std::string_view text) {
    return pageOf<FoundStudy>(text, kOfStudy, studyOf, &FoundStudy::studyInstanceUid);
}

Result<QidoPage<FoundSeries>> seriesInJson(std::string_view text) {
    return pageOf<FoundSeries>(text, kOfSeries, seriesOf, &FoundSeries::seriesInstanceUid);
}

Result<QidoPage<FoundInstance>> instancesInJson(std::string_view text) {
    return pageOf<FoundInstance>(text, kOfInstance, instanceOf, &FoundInstance::sopInstanceUid);
}

}  // namespace macula::net
