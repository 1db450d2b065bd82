// Finds images that form one series but have identifiers that were made separately for each of them.
#pragma once

#include <vector>

#include "base/text.h"
#include "dicom/stack/examination.h"

namespace macula::dicom {

struct Scattered {
    std::vector<std::size_t> images;  // indices in `found`
    Text levels;                      // those with different identifiers: "series", "study and series", …
};

// Finds three or more images, each the only one of its series, that agree in modality, series number and
// description, SOP class and size; that share one patient, or have one each, and likewise for study and
// series; and that make an even stack of one orientation and pixel spacing, possibly with gaps.
std::vector<Scattered> findScattered(const std::vector<Examination>& found);

// Gives the scattered images the patient, the study and the series of the first.
void join(std::vector<Examination>& found, const Scattered& scattered);

}  // namespace macula::dicom
