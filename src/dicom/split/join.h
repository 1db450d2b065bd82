// Images that are one series by all they say, but for identifiers that were made anew for each of them.
#pragma once

#include <string>
#include <vector>

#include "dicom/stack/examination.h"

namespace macula::dicom {

struct Scattered {
    std::vector<std::size_t> images;  // places in what was examined
    std::string levels;               // whose identifiers differ: "series", "study and series", …
};

// Three or more images, each the only one of its series: they agree in modality, series number and
// description, size, orientation and pixel spacing; their patients, studies and series are each one for all
// or one for every image; and together they make an even stack, with gaps perhaps.
std::vector<Scattered> findScattered(const std::vector<Examination>& found);

// Gives the scattered images the patient, the study and the series of the first.
void join(std::vector<Examination>& found, const Scattered& scattered);

}  // namespace macula::dicom
