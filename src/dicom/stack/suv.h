// Standardised uptake value of PET: the value of a voxel over the injected dose per body weight. After the
// vendor-neutral description of the Quantitative Imaging Biomarkers Alliance; PS3.3 C.8.9.1, C.8.9.2.
#pragma once

#include <optional>
#include <string>

#include "dicom/read/dataset.h"

namespace macula::dicom {

// Either a factor, or what is missing for one: a DICOM keyword, or a few words.
struct Suv {
    std::optional<double> factor;  // SUV in g/mL = factor * value
    std::string missing;
};

// Nothing is guessed: without units of Bq/mL (or g/mL), decay correction, dose, half-life, weight and both
// times there is no factor.
Suv suvOf(const Dataset& header);

}  // namespace macula::dicom
