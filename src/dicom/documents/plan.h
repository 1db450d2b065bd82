// Radiotherapy plans (PS3.3 A.20, A.49) as text. Only for the sources of this folder.
#pragma once

#include "dicom/documents/document.h"
#include "dicom/read/dataset.h"

namespace macula::dicom {

// Fills in title, status, entries and notes: label, intent, prescription, fraction groups and beams, in the
// units of the file (Gy, MU, degrees, mm). Brachytherapy is not read: a note says so.
void readPlan(StudyDocument& document, const Dataset& header);

}  // namespace macula::dicom
