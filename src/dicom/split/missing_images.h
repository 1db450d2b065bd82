// Finds images that a series lacks where positions cannot show it: at the ends of its slices. An interrupted
// copy is an even stack, but lacks the anatomy beyond its last slice.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dicom/stack/examination.h"
#include "dicom/stack/series.h"

namespace macula::dicom {

// The InstanceNumbers of missing images that the directory of a medium lists, by SeriesInstanceUID; nothing
// for an image without a listed number.
using AbsentImages = std::map<std::string, std::vector<std::optional<int>>>;

// Reports images that seem to be missing beyond the ends of a study's stacks (volumes of single-frame images)
// to these, or to the series if the end is unknown. The evidence, strongest first:
//   - the directory of the medium lists more images of the series (AbsentImages);
//   - NumberOfSeriesRelatedInstances, ImagesInAcquisition, or NumberOfSlices of PET, is larger than the
//     number of images; an ImagesInAcquisition that is three or more times that number, exactly, may count
//     other series and is a note;
//   - the image numbers, consecutive along the slices, begin late or leave some out next to an end. This is a
//     warning unless something else may explain it, and then a note: two numbers at most (deleted
//     localizers), or hundreds (a numbering with an offset). Numbers that continue those of another series,
//     or have the offset of the series number, are not evidence, nor are those of a stack that covers what a
//     complete one covers.
// Images in any stack are not missing. Gaps do not count, because stacks report them themselves.
void reportMissingImages(std::vector<Series>& series, const AbsentImages& absent);

// A note that the study has more objects (NumberOfStudyRelatedInstances) than were found.
std::optional<Message> studyShortfall(const std::vector<Series>& series);

// Compares the files that the directories of media (DICOMDIR) list with those found.
struct ListedFiles {
    std::size_t missing = 0;     // listed, but not found by name or UID
    std::size_t outside = 0;     // listed, but outside of the folder of their DICOMDIR
    std::size_t unreadable = 0;  // directories that cannot be read
    AbsentImages absent;         // the missing files whose series is known
};

// A listed file counts as present if a file has its name, or if one of `found` has its SOPInstanceUID, since
// copies of media give files other names.
ListedFiles compareWithDirectories(std::span<const std::filesystem::path> directories,
                                   std::span<const Examination> found);

}  // namespace macula::dicom
