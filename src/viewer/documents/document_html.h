// A document as text that a reading pane shows.
#pragma once

#include <QString>
#include <functional>

#include "dicom/documents/document.h"

namespace macula::viewer {

// The entries alone, in the language of the window. All text of the file is escaped: it is never read as
// HTML. `nameReference` says where an image is; empty: it is nowhere, and has no link. Links are "#N", where
// N is the place of the reference in StudyDocument::references().
QString htmlOf(const dicom::StudyDocument& document,
               const std::function<QString(const dicom::DocumentReference&)>& nameReference);

}  // namespace macula::viewer
