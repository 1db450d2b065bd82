// A document as plain text, for a terminal, a file or the clipboard.
#pragma once

#include <functional>
#include <string>

#include "dicom/documents/document.h"

namespace macula::dicom {

using SayText = std::function<std::string(const Text&)>;

// The heading of a document: what it is, whose, of when, and its status; then notes, then the entries, each
// deeper one indented. Lines end with \n. `say` puts a text into a language. `nameReference` may be null: it
// says where an image is, "Series 3, image 12"; empty where it is nowhere.
std::string plainTextOf(const StudyDocument& document, const SayText& say,
                        const std::function<std::string(const DocumentReference&)>& nameReference = {});

// Name with ID, birth date and sex as far as they are known; "Nobody is named as the patient." without.
Text patientLineOf(const StudyDocument& document);
// "2020-03-04, 14:05"; says so if the document has no date.
Text dateLineOf(const StudyDocument& document);
// "Structured report: Chest CT Report".
Text titleLineOf(const StudyDocument& document);
// "PDF, 20.6 kB"; empty if it is no file.
Text contentsLineOf(const StudyDocument& document);
// The heading of an entry, with how it relates to the one above: "Inferred from: Length".
Text headingOf(const DocumentEntry& entry);

}  // namespace macula::dicom
