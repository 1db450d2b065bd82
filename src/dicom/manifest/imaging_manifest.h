// Imaging manifests: which instances of a study there are, and where they can be fetched. They are Key Object
// Selection documents (PS3.3 A.35.4), as IHE MADO (Manifest-based Access to DICOM Objects) and XDS-I.b share
// them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "dicom/read/dataset.h"
#include "dicom/read/patient.h"

namespace macula::dicom {

struct ManifestInstance {
    std::string sopClassUid;
    std::string sopInstanceUid;
};

// Where a series lies, as far as the manifest says: an address of WADO-RS, an AE title, or the UID by which
// organisations that share images know the place. All of it is somebody's claim. Each once, in its order.
struct RetrievePlace {
    std::vector<std::string> urls;
    std::vector<std::string> aeTitles;
    std::vector<std::string> locationUids;
};

struct ManifestSeries {
    std::string seriesInstanceUid;
    RetrievePlace place;  // of the series, its study, or its instances
    std::vector<ManifestInstance> instances;
};

struct ManifestStudy {
    std::string studyInstanceUid;
    std::vector<ManifestSeries> series;

    std::size_t instances() const;
};

// UIDs, names and addresses may name a patient: for the screen, never logged.
struct ImagingManifest {
    std::string patientName;  // as the file has it
    PatientIdentity patient;
    std::string studyDate;
    std::string studyDescription;
    std::vector<ManifestStudy> studies;  // each once; none is empty
    std::size_t unusable = 0;            // references without a valid UID, which are left out
};

// How lists call such an object, as describeSopClass calls others.
Text imagingManifestKind();

// Whether an object that was read is one: by its class and the code of its title, which other Key Object
// Selections do not have. Never by a name.
bool isImagingManifest(const Dataset& header);

// Never throws. Fails with inputNotUsable where the file is no manifest, names no instances, or more than any
// study has; or with outOfMemory.
Result<ImagingManifest> readImagingManifest(const std::filesystem::path& path);

}  // namespace macula::dicom
