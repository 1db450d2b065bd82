// Classifies one file of a folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "dicom/read/patient.h"
#include "dicom/stack/instance.h"
#include "dicom/stack/series.h"

namespace macula::dicom {

// Holds all that grouping needs, so that the header can be dropped.
struct Examination {
    enum class Kind { image, imageWithoutPixels, other, directory };

    FileState state = FileState::notDicom;
    Kind kind = Kind::other;
    std::vector<Frame> frames;       // if it is an image; only frames with pixels in the file
    std::size_t framesMissing = 0;   // frames that the file claims but has no pixels for
    bool invalidFrameCount = false;  // NumberOfFrames is present, but no number
    OtherObject object;              // when kind is other
    std::string_view archive;        // when notDicom: see archiveKind
    bool charsetFallback = false;
    bool scattered = false;  // see Series::scattered

    std::string studyInstanceUid, studyDate, studyDescription, patientName;
    PatientIdentity patient;
    std::string sopInstanceUid, seriesInstanceUid, modality, seriesDescription, patientPosition;
    std::optional<int> seriesNumber;
};

// Reads the header, and nothing of the pixels. Once cancelled, discard the result. Thread-safe.
Examination examine(const std::filesystem::path& file, const CancelToken& cancel = {});

}  // namespace macula::dicom
