#include "study/archive/local_studies.h"

#include <algorithm>
#include <optional>
#include <system_error>
#include <utility>

#include "dicom/scan.h"
#include "dicom/stack/examination.h"

namespace macula::study {

namespace fs = std::filesystem;

namespace {

net::FoundStudy studyOf(const dicom::Examination& file) {
    net::FoundStudy study;
    study.studyInstanceUid = file.studyInstanceUid;
    study.date = file.studyDate;
    study.description = file.studyDescription;
    study.patientName = file.patientName;
    study.patientId = file.patient.id;
    study.patientBirthDate = file.patient.birthDate;
    study.patientSex = file.patient.sex;
    if (!file.modality.empty()) study.modalities = {file.modality};
    return study;
}

std::optional<net::FoundStudy> studyOfOneFile(const SpoolEntry& entry, const CancelToken& cancel) {
    std::error_code failure;
    for (fs::directory_iterator file(entry.folder, failure), end; !failure && file != end;
         file.increment(failure)) {
        if (cancel.cancelled()) return std::nullopt;
        if (file->path().extension() != ".dcm") continue;
        const dicom::Examination examined = dicom::examine(file->path(), cancel);
        if (examined.studyInstanceUid == entry.record.studyInstanceUid) return studyOf(examined);
    }
    return std::nullopt;
}

net::FoundStudy studyOf(const dicom::Study& scanned) {
    net::FoundStudy study;
    study.studyInstanceUid = scanned.studyInstanceUid;
    study.date = scanned.date;
    study.description = scanned.description;
    study.patientName = scanned.patientName;
    study.patientId = scanned.patientId;
    study.patientBirthDate = scanned.patientBirthDate;
    study.patientSex = scanned.patientSex;
    study.seriesCount = scanned.series.size();
    std::size_t instances = 0;
    for (const dicom::Series& series : scanned.series) {
        instances += series.instances + series.objects.size();
        if (!series.modality.empty() && std::ranges::count(study.modalities, series.modality) == 0)
            study.modalities.push_back(series.modality);
    }
    study.instanceCount = instances;
    return study;
}

// Of the largest volume, or of what there is: opening a file opens its series, and no other study.
fs::path fileOf(const dicom::Study& scanned) {
    constexpr std::size_t kWorthOfVolumes = 1'000'000;
    fs::path file;
    std::size_t most = 0;
    for (const dicom::Series& series : scanned.series) {
        for (const dicom::Stack& stack : series.stacks) {
            const std::size_t worth = stack.frames.size() * (stack.canBeVolume() ? kWorthOfVolumes : 1);
            if (worth <= most) continue;
            most = worth;
            file = stack.frames.front().instance->file;
        }
        if (file.empty() && !series.objects.empty()) file = series.objects.front().file;
    }
    return file;
}

}  // namespace

std::vector<LocalStudy> studiesInSpool(const Spool& spool, const CancelToken& cancel) {
    std::vector<LocalStudy> studies;
    for (const SpoolEntry& entry : spool.entries()) {
        if (cancel.cancelled()) break;
        if (entry.instances == 0) continue;
        auto study = entry.record.asFound ? entry.record.asFound : studyOfOneFile(entry, cancel);
        if (!study) continue;
        study->instanceCount = entry.instances;
        studies.push_back({.study = *std::move(study),
                           .folder = entry.folder,
                           .archive = entry.record.source,
                           .isWhole = entry.record.isComplete});
    }
    return studies;
}

std::vector<LocalStudy> studiesInFolder(const fs::path& folder, const CancelToken& cancel) {
    Progress progress({}, cancel);
    const auto scan = dicom::scanFolder(folder, progress);
    std::vector<LocalStudy> studies;
    if (!scan) return studies;
    for (const dicom::Study& each : scan->studies) {
        const fs::path file = fileOf(each);
        if (!each.studyInstanceUid.empty() && !file.empty())
            studies.push_back({.study = studyOf(each), .folder = file, .archive = {}, .isWhole = true});
    }
    return studies;
}

}  // namespace macula::study
