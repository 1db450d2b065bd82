#include "dicom/scan_glimpse.h"

#include <algorithm>

namespace macula::dicom {

namespace {

constexpr std::chrono::milliseconds kGlimpseEvery{300};
constexpr int kMostShareOfTime = 10;  // at most one part in this many

}  // namespace

void ScanGlimpses::add(const Examination& found) {
    if (!listener_ || found.state != FileState::complete || found.seriesInstanceUid.empty()) return;
    if (found.kind != Examination::Kind::image && found.kind != Examination::Kind::other) return;
    const std::lock_guard lock(mutex_);
    StudySeen& place = studies_[{found.studyInstanceUid, found.patient}];
    if (place.series.empty()) {
        place.study = {.studyInstanceUid = found.studyInstanceUid,
                       .date = found.studyDate,
                       .description = found.studyDescription,
                       .patientName = found.patientName,
                       .patientId = found.patient.id,
                       .series = {},
                       .patientBirthDate = found.patient.birthDate,
                       .patientSex = found.patient.sex,
                       .patient = patients_.of(found.patient, found.studyInstanceUid)};
    }
    const auto [series, isNew] = place.series.try_emplace(found.seriesInstanceUid);
    if (isNew) {
        series->second.studyInstanceUid = found.studyInstanceUid;
        series->second.seriesInstanceUid = found.seriesInstanceUid;
        series->second.modality = found.modality;
        series->second.description = found.seriesDescription;
        series->second.number = found.seriesNumber;
    }
    if (found.kind == Examination::Kind::image) ++series->second.instances;
    const Clock::time_point now = Clock::now();
    if (now < due_) return;
    listener_(seen());
    const Clock::time_point told = Clock::now();
    due_ = told + std::max<Clock::duration>(kGlimpseEvery, (told - now) * kMostShareOfTime);
}

Scan ScanGlimpses::seen() const {
    Scan scan;
    scan.patients = patients_.count();
    scan.namelessPatients = patients_.nameless();
    for (const auto& [key, place] : studies_) {
        Study& study = scan.studies.emplace_back(place.study);
        for (const auto& [uid, series] : place.series) study.series.push_back(series);
        std::ranges::stable_sort(study.series, {}, [](const Series& s) { return s.number.value_or(0); });
    }
    std::ranges::stable_sort(scan.studies, {}, &Study::date);
    return scan;
}

}  // namespace macula::dicom
