// Standardised uptake value of PET: the value of a voxel over the injected dose per body weight. After the
// vendor-neutral description of the Quantitative Imaging Biomarkers Alliance; PS3.3 C.8.9.1, C.8.9.2.
#pragma once

#include <optional>

#include "base/text.h"
#include "dicom/read/dataset.h"

namespace macula::dicom {

// Either a factor, or what it lacks: a DICOM keyword, or a few words.
struct Suv {
    std::optional<double> factor;  // SUV in g/mL = factor * value
    Text missing;
};

// There is no factor without units of Bq/mL (or g/mL), decay correction, dose, half-life, weight and both
// times; none of these is guessed.
Suv suvOf(const Dataset& header);

}  // namespace macula::dicom
