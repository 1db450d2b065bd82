// What one file of a folder turns out to be.
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

// All that grouping needs, so that headers are dropped as soon as they are read.
struct Examination {
    enum class Kind { image, imageWithoutPixels, other, directory };

    FileState state = FileState::notDicom;
    Kind kind = Kind::other;
    std::vector<Frame> frames;       // of an image; those that the file has pixels for
    std::size_t framesMissing = 0;   // frames that the file claims and has no pixels for
    bool invalidFrameCount = false;  // NumberOfFrames is there, and is no number
    OtherObject object;              // when kind is other
    std::string_view archive;        // of what is notDicom: see archiveKind
    bool charsetFallback = false;
    bool scattered = false;  // see Series::scattered

    std::string studyInstanceUid, studyDate, studyDescription, patientName;
    PatientIdentity patient;
    std::string sopInstanceUid, seriesInstanceUid, modality, seriesDescription, patientPosition;
    std::optional<int> seriesNumber;
};

// Reads the header, and nothing of the pixels. Once cancelled, the result is to be thrown away. Thread-safe.
Examination examine(const std::filesystem::path& file, const CancelToken& cancel = {});

}  // namespace macula::dicom
