// Finds the volume of a folder that a presentation state shows.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "base/text.h"
#include "study/open/found_volumes.h"

namespace macula::study {

struct PresentedVolume {
    std::optional<std::size_t> index = {};  // in FoundVolumes::volumes(); nothing: see whyNot
    Text whyNot = {};                       // a sentence; empty where there is a volume
};

// Of the series that the object refers to, chooses the volume with the most of its images or frames. Object
// and series must belong to one patient, unless the object is deidentified: it then refers by stand-in UIDs
// (dicom::StandInUids), which fit one series only. `patient` is Study::patient of the study of the object.
PresentedVolume presentedVolume(const dicom::OtherObject& object, int patient, const FoundVolumes& found);

}  // namespace macula::study
