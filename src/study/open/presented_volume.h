// Which volume of a folder a presentation state is of.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "study/open/found_volumes.h"

namespace macula::app {

struct PresentedVolume {
    std::optional<std::size_t> index = {};  // in FoundVolumes::volumes(); nothing: see whyNot
    std::string whyNot = {};                // a sentence; empty where there is a volume
};

// Of the series that the object refers to, the volume that has most of its images, or frames of them. The
// series must be of the patient whom the object is of, unless the object names nobody: then it has made UIDs
// anew (dicom::uidFrom), which are of one series only. `patient` is Study::patient of the study that the
// object lies in.
PresentedVolume presentedVolume(const dicom::OtherObject& object, int patient, const FoundVolumes& found);

}  // namespace macula::app
