// Reads a document of a study.
#pragma once

#include <filesystem>
#include <string>

#include "base/result.h"
#include "dicom/documents/document.h"

namespace macula::dicom {

// Never throws. Reads what there is: what is not valid is said in StudyDocument::notes. Fails with
// inputNotUsable when the file cannot be read, is nested deeper than any real one, or is no document; with
// outOfMemory.
Result<StudyDocument> readDocument(const std::filesystem::path& file);

// The title of a document for a list: of a report its concept, of a file its title, of a plan its label. From
// the header alone; may be empty.
std::string documentTitleOf(const Dataset& header);

// The bytes of an encapsulated file without padding (PS3.3 C.24.2). Fails with inputNotUsable when there are
// none, or more than 1 GiB; with outOfMemory. Never throws.
Result<std::string> readEncapsulatedFile(const std::filesystem::path& file);

// Whether the bytes begin as a PDF (ISO 32000-1, 7.5.2): within the first 1024 of them.
bool beginsAsPdf(std::string_view bytes);

}  // namespace macula::dicom
