// What a person opens: a folder, a file, or nothing.
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
#include "study/open/identity.h"

namespace macula::app {

class FoundVolumes;

// What came out of a folder. All strings are for the screen; they may name a patient.
struct OpenedStudy {
    std::shared_ptr<const Volume> volume;  // stored16, to be drawn; null when there is only a question
    // The same in floats, as the file has it, where 16 bits do not hold all of its values; else null.
    std::shared_ptr<const Volume> inFloats = {};
    std::string seriesDigest = {};  // see StudyInput
    Identity identity = {};
    std::string description = {};
    std::string whyThisSeries = {};          // empty for the phantom
    std::vector<std::string> messages = {};  // warnings about the series and about files left out
    // All volumes of the folder, and which of them this is; null for the phantom and files of one volume.
    std::shared_ptr<const FoundVolumes> found = {};
    std::vector<std::string> volumeTitles = {};
    std::size_t volumeIndex = 0;
    std::vector<int> imageNumbers = {};    // of its slices: see imageNumbersOf()
    bool isLowBright = false;              // low values are shown white: MONOCHROME1, and PET by custom
    std::string joinQuestion = {};         // see dicom::ScanOptions
    std::string frameOfReferenceUid = {};  // PS3.3 C.7.4.1; empty: not known
    std::string stateAsLeft = {};          // ModelKeeper::stateOf; empty: nobody knows how it was left

    // What slices show and what is measured: no value is another than in the file.
    const std::shared_ptr<const Volume>& measured() const { return inFloats ? inFloats : volume; }
};

// A folder, or the DICOMDIR in it, of which the best series is meant; an image, of which its own series in
// its folder is meant; or a file that is a volume by itself (formats/volume_file.h). Nothing is the built-in
// phantom.
using StudySource = std::optional<std::filesystem::path>;

// Told of a folder while it is opened: what was found so far, now and then, and all of it before the volume
// is decoded. Called on threads that read, one at a time.
using FoundSoFar = std::function<void(std::shared_ptr<const FoundVolumes>)>;

struct OpenOptions {
    bool join = false;  // see dicom::ScanOptions
    FoundSoFar foundSoFar = {};
    // Of a folder that series, wherever `source` leads to: as FoundVolumes::ofSeries. Empty: not given.
    std::string series = {};
    // A folder whose volumes are of several patients is an error that lists them (whichPatient), where no
    // series is given: for who has nobody to look at the name of who is shown.
    bool asksWhichPatient = false;
};

// Scans, chooses the series and decodes it; of a folder the best one that can be decoded, and says which
// could not. Blocks; a file at a time sees a cancellation. Throws nothing.
Result<OpenedStudy> openStudy(const StudySource& source, Progress& progress, const OpenOptions& how = {});
// Decodes another volume of the folder.
Result<OpenedStudy> openFoundVolume(std::shared_ptr<const FoundVolumes> found, std::size_t index,
                                    Progress& progress);

}  // namespace macula::app
