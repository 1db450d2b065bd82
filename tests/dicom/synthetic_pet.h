// PET of which the SUV is known.
#pragma once

#include "synthetic.h"

namespace macula::dicom::test {

// Of 70 kg and 350 MBq, corrected to the time of administration.
inline constexpr double kSuvPerBqPerMl = 70'000.0 / 350e6;

// In Bq/mL, with a slope of 10 and all that a factor needs; its window is that of a scanner, over all values.
// Without a dose it has none.
SyntheticSeries petSeries(bool hasDose = true);

}  // namespace macula::dicom::test
