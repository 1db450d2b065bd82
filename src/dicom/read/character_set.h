// Text of DICOM files as UTF-8. PS3.3 C.12.1.1.2, PS3.5 6.1.
//
// Escape sequences are followed here and not by DCMTK's DcmSpecificCharacterSet (3.6.7), which over glibc has
// no converter for kanji, reads ISO_IR 13 as Shift-JIS, does not know Latin-9, and of text that breaks a rule
// gives nothing.
#pragma once

#include <string>
#include <string_view>

#include "base/utf8.h"

namespace macula::dicom {

// What ends the effect of an escape sequence, besides the end of a line (PS3.5 6.1.2.5.3).
enum class Delimiters { none, betweenValues, ofPersonNames };

struct DecodedText {
    std::string utf8;  // always valid, and without control characters but the ends of lines and tabs
    // The bytes are not what was declared, and were read as what they most likely are: as UTF-8 if that is
    // possible, else as Latin-1. Never so for plain ASCII.
    bool fallback = false;
};

// `declared` is SpecificCharacterSet as in the file, its values separated by backslashes. Thread-safe.
DecodedText decodeText(std::string_view bytes, std::string_view declared, Delimiters delimiters);

}  // namespace macula::dicom
