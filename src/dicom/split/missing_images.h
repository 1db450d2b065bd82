// Images that a series should have and has not, where positions cannot show it: at the ends of its slices. A
// copy that was stopped is an even stack, and lacks the anatomy beyond its last slice.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "dicom/stack/series.h"

namespace macula::dicom {

// The numbers (InstanceNumber) of images that the directory of a medium lists and that are not there, by
// SeriesInstanceUID; nothing for an image of which it says none.
using AbsentImages = std::map<std::string, std::vector<std::optional<int>>>;

// Tells the stacks of one study, each a volume of single-frame images, of what seems to be missing beyond
// their ends, and the series where no end can be named. What counts as evidence, from the strongest:
//   - the directory of the medium lists more images of the series (AbsentImages);
//   - NumberOfSeriesRelatedInstances, ImagesInAcquisition, or NumberOfSlices of PET, is larger than the
//   number of
//     images; ImagesInAcquisition that is three times as many or more may count other series, and is a note;
//   - the image numbers, consecutive along the slices, begin late or leave some out next to an end. This is a
//     warning unless something else may explain it, and then a note: two numbers at most (deleted
//     localizers), or hundreds (a numbering with an offset). Numbers that go on from another series, or have
//     the offset of the series number, say nothing, and neither do those of a stack that covers what a
//     complete one covers.
// Images that are there, in whatever stack, are not missing; nor are gaps counted, which stacks tell
// themselves.
void reportMissingImages(std::vector<Series>& series, const AbsentImages& absent);

// A note that the study has more objects (NumberOfStudyRelatedInstances) than are here.
std::optional<Message> studyShortfall(const std::vector<Series>& series);

}  // namespace macula::dicom
