// Opens a folder, a file, or the built-in phantom.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "dicom/dose/dose_facts.h"
#include "study/open/identity.h"

namespace macula::study {

class FoundVolumes;
struct VolumesOfFile;

// An opened source. All strings are for the screen; they may name a patient.
struct OpenedStudy {
    std::shared_ptr<const Volume> volume;  // stored16, for drawing; null when joinQuestion is set
    // The same in float32, as loaded, where 16 bits cannot hold all of its values; otherwise null.
    std::shared_ptr<const Volume> inFloats = {};
    std::string seriesDigest = {};  // see LoadedStudy
    Identity identity = {};
    Text description = {};
    Text whyThisSeries = {};          // empty for the phantom
    std::vector<Text> messages = {};  // warnings about the series and about files left out
    // All volumes of the folder, and which of them this is; null for the phantom and files of one volume.
    std::shared_ptr<const FoundVolumes> found = {};
    std::vector<Text> volumeTitles = {};
    std::size_t volumeIndex = 0;
    // All volumes of a file with several, of which this is number `volumeIndex`, from 0; otherwise null.
    std::shared_ptr<const VolumesOfFile> ofFile = {};
    std::vector<int> imageNumbers = {};         // of its slices: see imageNumbersOf()
    bool isLowBright = false;                   // low values are drawn white: MONOCHROME1, and PET by custom
    Text joinQuestion = {};                     // see dicom::ScanOptions
    std::string frameOfReferenceUid = {};       // PS3.3 C.7.4.1; empty: unknown
    std::string stateAsLeft = {};               // StudyKeeper::stateOf; empty: no state was kept
    std::optional<dicom::DoseFacts> dose = {};  // of a radiotherapy dose; nothing: it is none

    // The volume for slices and measurements, with values that are not rounded to 16 bits.
    const std::shared_ptr<const Volume>& measured() const { return inFloats ? inFloats : volume; }
};

// A folder or its DICOMDIR: the best series is opened. An image: its series, from the files in its folder. A
// volume file (formats/volume_file.h): that volume. Nothing: the built-in phantom.
using StudySource = std::optional<std::filesystem::path>;

// Receives the volumes found so far while a folder is opened: now and then during the scan, and all of them
// before one is decoded. Calls come from reading threads and that of openStudy, and never overlap.
using FoundSoFar = std::function<void(std::shared_ptr<const FoundVolumes>)>;

struct OpenRequest {
    bool join = false;  // see dicom::ScanOptions
    FoundSoFar foundSoFar = {};
    // The series to open (FoundVolumes::ofSeries), also where `source` is an image. Empty: not given.
    std::string series = {};
    // Without a series, a folder with volumes of several patients is an error that lists them (whichPatient):
    // for callers whose user cannot check the name of the patient on screen.
    bool asksWhichPatient = false;
};

// Scans, chooses a series and decodes it: for a folder the best series that can be decoded, with messages on
// better ones that cannot. Blocks; checks for cancellation after each file. Throws nothing.
Result<OpenedStudy> openStudy(const StudySource& source, Progress& progress, const OpenRequest& how = {});
// Decodes another volume of the folder.
Result<OpenedStudy> openFoundVolume(std::shared_ptr<const FoundVolumes> found, std::size_t index,
                                    Progress& progress);
// Reads another volume of the file, and no more. inputNotUsable where the file is another one by now.
Result<OpenedStudy> openVolumeOfFile(std::shared_ptr<const VolumesOfFile> volumes, std::size_t index,
                                     Progress& progress);

}  // namespace macula::study
