// Text of DICOM files as UTF-8. PS3.3 C.12.1.1.2, PS3.5 6.1.
//
// This code follows escape sequences itself, because DCMTK's DcmSpecificCharacterSet (3.6.7) with glibc has
// no converter for kanji, reads ISO_IR 13 as Shift-JIS, does not know Latin-9, and gives nothing for text
// that breaks a rule.
#pragma once

#include <string>
#include <string_view>

#include "base/utf8.h"

namespace macula {

// The delimiters that, besides the end of a line, end an escape sequence's effect (PS3.5 6.1.2.5.3).
enum class Delimiters { none, betweenValues, ofPersonNames };

struct DecodedText {
    std::string utf8;  // always valid, and without control characters but the ends of lines and tabs
    // Whether the bytes contradict the declared character set and were read as UTF-8 if that is possible,
    // otherwise as Latin-1. Never true for plain ASCII.
    bool fallback = false;
};

// `declared` is SpecificCharacterSet as in the file, its values separated by backslashes. Thread-safe.
DecodedText decodeText(std::string_view bytes, std::string_view declared, Delimiters delimiters);

}  // namespace macula
