// Loads a volume from the path that the user gave.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "dicom/best_volume.h"
#include "dicom/read/referenced_frames.h"
#include "dicom/scan.h"
#include "study/open/found_volumes.h"
#include "study/open/identity.h"

namespace macula::study {

struct LoadedStudy {
    std::shared_ptr<const Volume> volume;
    std::vector<Text> notes;                           // sentences for the user, without patient data
    std::vector<Text> warnings;                        // the notes that affect what is seen
    std::vector<dicom::ReferencedFrames> images = {};  // as imagesOf; empty: unknown
    std::string seriesDigest;    // SHA-256 of the Series Instance UID, of the voxels of a file, or "phantom"
    std::string volumeKey = {};  // FoundVolumes::key; empty where there is no series
    std::string frameOfReferenceUid = {};  // as frameOfReferenceOf
    Identity identity = {};                // only for comparison with another study
};

// The unit of PET values: SUV by body weight where the images allow it (dicom::Suv), as in the window and its
// saved views, or the unit of the images.
enum class PetUnit { suv, asInImages };

// An empty path or "phantom:" loads the built-in phantom. `series` is a place in the list of `macula info`
// ("2", or "2.3" for the third stack) or a UID; empty: the best. `volume` chooses a stack of the series, from
// 1; 0: the best. In a NIfTI or NRRD file with a volume for each point in time it chooses one of these.
Result<LoadedStudy> loadStudy(const std::filesystem::path& path, const std::string& series,
                              Progress& progress, std::size_t volume = 0, const dicom::ScanOptions& how = {},
                              PetUnit petUnit = PetUnit::suv);

// The same for a folder that was scanned.
Result<LoadedStudy> loadStudy(const dicom::Scan& scan, const std::filesystem::path& path,
                              const std::string& series, Progress& progress, std::size_t volume = 0,
                              PetUnit petUnit = PetUnit::suv);

// The series with that place or UID; null when there is none, or when several patients have it.
const dicom::Series* seriesMeant(const dicom::Scan& scan, const std::string& wanted);

// Chooses as loadStudy does, and loads nothing. `why` is empty if the caller named the stack, or a series
// that has only one.
Result<dicom::ChosenStack> chooseVolume(const dicom::Scan& scan, const std::string& series,
                                        std::size_t volume = 0);

// Brings the volume to 16 bits, for drawing and tracing. Adds what that changed to the notes.
void bringTo16Bits(LoadedStudy& study);

// The study to read. Empty fields: not given.
struct StudyPlace {
    std::filesystem::path path;
    std::string series;                  // as loadStudy
    std::filesystem::path presentation;  // a presentation state, whose series is read if `series` is empty
    dicom::ScanOptions how;
};

// Whether `path` may have segmentations: a DICOM folder may; a volume file and the phantom have none.
bool mayHoldSegmentations(const std::filesystem::path& path);

// A study for a picture, with the folder for its segmentations.
struct ReadStudy {
    LoadedStudy input;
    std::string series;                         // for chooseVolume; may be empty
    std::shared_ptr<const FoundVolumes> found;  // the folder; null unless segmentations are needed
    dicom::ScanOptions how;
};

// Fails as loadStudy, and as readPresentationState.
Result<ReadStudy> readStudy(const StudyPlace& place, bool needsSegmentations, Progress& progress);

}  // namespace macula::study
