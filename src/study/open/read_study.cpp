#include "study/open/read_study.h"

#include <utility>

#include "dicom/presentation/presentation_state.h"
#include "formats/volume_file.h"

namespace macula::study {

namespace {

// The requested series, otherwise the one that the presentation state refers to; empty if neither is given.
Result<std::string> requestedSeries(const StudyPlace& place, const dicom::Scan& scan) {
    if (!place.series.empty() || place.presentation.empty()) return place.series;
    MACULA_TRY(const dicom::PresentationState read, dicom::readPresentationState(place.presentation));
    const std::string& uid = read.presentation.series.seriesInstanceUid;
    // A deidentified state refers to its series by a UID that the folder lacks.
    return dicom::findAllSeries(scan, uid).empty() ? std::string() : uid;
}

}  // namespace

bool mayHoldSegmentations(const std::filesystem::path& path) {
    return !path.empty() && path != "phantom:" && !formats::isVolumeFileName(path);
}

Result<ReadStudy> readStudy(const StudyPlace& place, bool needsSegmentations, Progress& progress) {
    ReadStudy study;
    study.how = place.how;
    if (!mayHoldSegmentations(place.path)) {
        MACULA_TRY(study.input, loadStudy(place.path, place.series, progress, 0, place.how));
        return study;
    }
    MACULA_TRY(dicom::Scan scan, dicom::scanFolder(place.path, progress, place.how));
    MACULA_TRY(study.series, requestedSeries(place, scan));
    MACULA_TRY(study.input, loadStudy(scan, place.path, study.series, progress));
    if (needsSegmentations) study.found = std::make_shared<const FoundVolumes>(std::move(scan));
    return study;
}

}  // namespace macula::study
