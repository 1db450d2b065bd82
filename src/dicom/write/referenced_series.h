// The images to which a written object refers.
#pragma once

#include <string>
#include <vector>

#include "base/installation_key.h"
#include "base/result.h"
#include "dicom/stack/series.h"

namespace macula::dicom {

struct ReferencedImage {
    std::string sopClassUid;
    std::string sopInstanceUid;
    std::vector<int> frames = {};  // from 1; none: all of them

    bool operator==(const ReferencedImage&) const = default;
};

// UIDs may name a patient: never logged.
struct PresentedSeries {
    std::string seriesInstanceUid;
    std::string frameOfReferenceUid;
    std::vector<ReferencedImage> images;

    bool operator==(const PresentedSeries&) const = default;
};

// Fails with usage for images that were joined into one series although each has one of its own, which a
// reference would not name.
Result<void> checkReferable(const Series& series);

// The series as deidentified objects refer to it: by standInUid.
PresentedSeries withStandIns(PresentedSeries series, const InstallationKey& key);

}  // namespace macula::dicom
