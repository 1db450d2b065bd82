// What a person opens: a folder, a file, or nothing.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/study/identity.h"
#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"

namespace macula::app {

class FoundVolumes;

// What came out of a folder. All strings are for the screen; they may name a patient.
struct OpenedStudy {
    std::shared_ptr<const Volume> volume;  // null when there is only a question
    std::string seriesDigest = {};         // see StudyInput
    Identity identity = {};
    std::string description = {};
    std::string whyThisSeries = {};          // empty for the phantom
    std::vector<std::string> messages = {};  // warnings about the series and about files left out
    // All volumes of the folder, and which of them this is; null for the phantom and files of one volume.
    std::shared_ptr<const FoundVolumes> found = {};
    std::vector<std::string> volumeTitles = {};
    std::size_t volumeIndex = 0;
    std::vector<int> imageNumbers = {};    // of its slices: see imageNumbersOf()
    bool isLowBright = false;              // its own display shows low values white (MONOCHROME1)
    std::string joinQuestion = {};         // see dicom::ScanOptions
    std::string frameOfReferenceUid = {};  // PS3.3 C.7.4.1; empty: not known
    std::string stateAsLeft = {};          // ModelKeeper::stateOf; empty: nobody knows how it was left
};

// A folder, or the DICOMDIR in it, of which the best series is meant; an image, of which its own series in
// its folder is meant; or a file that is a volume by itself (formats/volume_file.h). Nothing is the built-in
// phantom.
using StudySource = std::optional<std::filesystem::path>;

// Told of a folder while it is opened: what was found so far, now and then, and all of it before the volume
// is decoded. Called on threads that read, one at a time.
using FoundSoFar = std::function<void(std::shared_ptr<const FoundVolumes>)>;

// Scans, chooses the series and decodes it; of a folder the best one that can be decoded, and says which
// could not. Blocks; a file at a time sees a cancellation. Throws nothing. With a Series Instance UID it is
// that series, wherever `source` leads to.
Result<OpenedStudy> openStudy(const StudySource& source, Progress& progress, bool join = false,
                              const FoundSoFar& foundSoFar = {}, const std::string& seriesInstanceUid = {});
// Decodes another volume of the folder.
Result<OpenedStudy> openFoundVolume(std::shared_ptr<const FoundVolumes> found, std::size_t index,
                                    Progress& progress);

}  // namespace macula::app
