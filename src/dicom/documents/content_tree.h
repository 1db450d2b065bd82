// The content tree of a structured report (PS3.3 C.17.3) as entries of a document. Only for the sources of
// this folder.
#pragma once

#include "dicom/documents/document.h"
#include "dicom/read/dataset.h"

namespace macula::dicom {

// Adds the entries below the root, without recursion, and notes on what is not valid or not read. At most
// 10 000 entries and 4 MiB of text are read: a note says so. An item that refers to another one names it, and
// is not followed, so that loops end.
void addContent(StudyDocument& document, const Dataset& root);

}  // namespace macula::dicom
