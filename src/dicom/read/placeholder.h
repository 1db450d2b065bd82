// Recognises placeholders: values that stand for a patient who was left out or unknown.
#pragma once

#include <string_view>

namespace macula::dicom {

// Whether a name or an ID is empty, "ANONYMOUS", "Patient^Anonymous", "DE-IDENTIFIED", "0000", "XXXX" or the
// like, in any case and with any punctuation. Equal placeholders do not mean one patient, any more than empty
// values do. A word with a number ("ANON0017") is a pseudonym, and identifies a patient.
bool isPlaceholder(std::string_view text);

// Whether a date of birth, with or without points, is empty, not a date, or one that programs write when they
// know none, such as 19000101, 00010101 and any before 1880.
bool isPlaceholderDate(std::string_view date);

}  // namespace macula::dicom
