// Of whom a file is, by its header alone.
#pragma once

#include "dicom/stack/examination.h"
#include "study/open/identity.h"

namespace macula::study {

// Without the line of the series.
Identity identityOf(const dicom::Examination& file);

}  // namespace macula::study
