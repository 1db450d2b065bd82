// Whether two studies belong to one patient, and which is the earlier one.
#pragma once

#include <string>
#include <vector>

#include "study/open/identity.h"

namespace macula::study {

// Compares the images' attributes. no: ID, name, date of birth or sex is in both and differs. yes: both
// belong to one study, or all four agree and there is an ID or a name, or both are of nobody. Otherwise
// unknown, as for files without names; placeholders (dicom::isPlaceholder) count as empty.
enum class SamePatient { yes, no, unknown };
SamePatient samePatient(const Identity& a, const Identity& b);
// The names of the attributes that differ, without values: {"ID", "date of birth"}.
std::vector<std::string> whatDiffers(const Identity& a, const Identity& b);

enum class Age { earlier, sameDay, later, unknown };
// Whether `second` is earlier or later than `study`, by the dates of the studies.
Age ageOf(const Identity& study, const Identity& second);

// The day of the study as YYYYMMDD; empty where the images name none.
std::string studyDay(const Identity& identity);

}  // namespace macula::study
