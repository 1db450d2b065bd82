// Structured reports and key object selections (PS3.3 A.35). Only for the sources of this folder.
#pragma once

#include "dicom/documents/document.h"
#include "dicom/read/dataset.h"

namespace macula::dicom {

// Fills in title, status, entries and notes.
void readReport(StudyDocument& document, const Dataset& header);

}  // namespace macula::dicom
