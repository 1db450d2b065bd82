// From the path the user gave to a volume.
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
#include "study/open/identity.h"

namespace macula::app {

struct StudyInput {
    std::shared_ptr<const Volume> volume;
    std::vector<std::string> notes;                    // sentences for the user, without patient data
    std::vector<std::string> warnings;                 // those of them that change what is seen
    std::vector<dicom::ReferencedFrames> images = {};  // as imagesOf; empty: not known
    std::string seriesDigest;    // SHA-256 of the Series Instance UID, of the voxels of a file, or "phantom"
    std::string volumeKey = {};  // FoundVolumes::key; empty where there is no series
    std::string frameOfReferenceUid = {};  // as frameOfReferenceOf
    Identity identity = {};                // to compare with that of another study, and for nothing else
};

// What values of PET are in: SUV by body weight where all it needs is there (dicom::Suv), as the window shows
// them and its saved views say them, or what the images have.
enum class PetUnit { suv, asInImages };

// No path, or "phantom:", is the built-in phantom. `series` chooses by its place in the list of `macula info`
// ("2", or "2.3" for its third stack of images) or by its UID; when empty, or when the series has several
// volumes, the best is taken; `volume` (from 1) chooses among those of the series. Of a NIfTI or
// NRRD file with a volume for each point in time it chooses among those.
Result<StudyInput> loadStudy(const std::filesystem::path& path, const std::string& series, Progress& progress,
                             std::size_t volume = 0, const dicom::ScanOptions& how = {},
                             PetUnit petUnit = PetUnit::suv);

// The same for a folder that was scanned.
Result<StudyInput> loadStudy(const dicom::Scan& scan, const std::filesystem::path& path,
                             const std::string& series, Progress& progress, std::size_t volume = 0,
                             PetUnit petUnit = PetUnit::suv);

// The series of that place or UID; null when there is none, or several patients have it.
const dicom::Series* seriesMeant(const dicom::Scan& scan, const std::string& wanted);

// Only the choice that loadStudy makes. `why` is empty when there was nothing to choose from.
Result<dicom::Choice> chooseVolume(const dicom::Scan& scan, const std::string& series,
                                   std::size_t volume = 0);

// For what draws or traces the study: 16 bits, with what that cost among the notes.
void bringTo16Bits(StudyInput& study);

}  // namespace macula::app
