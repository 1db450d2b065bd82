// Whether two studies are of one patient, and which is the earlier one.
#pragma once

#include <string>
#include <vector>

#include "study/open/identity.h"

namespace macula::app {

// As far as the images tell. Different when ID, name, date of birth or sex is in both and differs. One when
// both are of one study, or all four agree and there is an ID or a name. Else nobody can know, as with files
// without names; what is written where nobody is named (dicom::isPlaceholder) is as if it were empty.
enum class SamePatient { yes, no, unknown };
SamePatient samePatient(const Identity& a, const Identity& b);
// What differs, in words and without values: {"ID", "date of birth"}.
std::vector<std::string> whatDiffers(const Identity& a, const Identity& b);

enum class Age { earlier, sameDay, later, unknown };
// Of the second against the study, by the dates of the studies.
Age ageOf(const Identity& study, const Identity& second);

// The day of the study as YYYYMMDD; empty where the images name none.
std::string studyDay(const Identity& identity);

}  // namespace macula::app
