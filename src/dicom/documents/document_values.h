// Values of documents in words. Only for the sources of this folder.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/coded_name.h"
#include "base/text.h"
#include "dicom/documents/document.h"
#include "dicom/read/dataset.h"

namespace macula::dicom {

// Lines end with \n; other control characters become question marks (printable.h).
std::string inLines(std::string_view text);
// Text of the file, not translated; empty where there is none.
Text wordsOf(const Dataset& item, Tag tag);

// The first item of a code sequence (PS3.3 8.8); empty without one.
CodedName codeIn(const Dataset& item, Tag sequence);
// Its meaning, otherwise the code with its scheme, "T-04000 (SRT)".
Text wordsOf(const CodedName& code);
// A unit as people write it: "mm", "cm²", "HU"; empty for "no units".
std::string unitOf(const CodedName& unit);

// "DOE^JANE^^DR" as "DOE, JANE, DR"; other representations follow in brackets.
std::string personOf(std::string_view name);
// "20200304", "1405", "20200304140530+0100" as "2020-03-04", "14:05", "2020-03-04 14:05:30 +0100"; anything
// else as it is.
std::string dateOf(std::string_view date);
std::string timeOf(std::string_view time);
std::string dateTimeOf(std::string_view dateTime);

// A plain number, without zeros at its end: "6", "0.25".
std::string numberText(double number);

// The items of a sequence of references; `unusable` counts those without an instance.
std::vector<DocumentReference> referencesIn(const Dataset& item, Tag sequence, std::size_t& unusable);

// What "CT image, frames 1 to 3" is called.
Text nameOf(const DocumentReference& reference);

}  // namespace macula::dicom
