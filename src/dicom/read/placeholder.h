// What is written for a patient where nobody is named: by who left the patient out, or did not know.
#pragma once

#include <string_view>

namespace macula::dicom {

// Of a name or an ID: nothing, "ANONYMOUS", "Patient^Anonymous", "DE-IDENTIFIED", "0000", "XXXX", in
// whichever case and with whatever signs between. Such a value is no value: two that are equal are of one
// patient no more than two that are empty. A word with a number ("ANON0017") is a pseudonym, and tells
// patients apart.
bool isPlaceholder(std::string_view text);

// Of a date of birth, with points or without: nothing, no date at all, or one that programs write where they
// know none, such as 19000101 and 00010101, and any before 1880.
bool isPlaceholderDate(std::string_view date);

}  // namespace macula::dicom
