// Decodes the bytes of a data element by its value representation (PS3.5 6.2).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/parsing.h"
#include "dicom/read/dictionary.h"

namespace macula::dicom {

bool isTextVr(Vr vr);
// Whether text is in the character set of the file (PS3.5 6.1.2.2); other text is in the default one.
bool usesCharacterSet(Vr vr);
// Digits and dots, at most 64 (PS3.5 9.1), as far as Macula relies on it.
bool isUid(std::string_view text);
std::vector<std::string_view> splitAtBackslash(std::string_view text);  // each trimmed

// The values of a binary numeric VR; empty for other VRs, or when the length does not fit.
std::vector<double> binaryNumbers(Vr vr, std::string_view bytes, bool bigEndian);
// The words of a VR of 16 bits, or of bytes (two make one word).
std::vector<std::uint16_t> binaryWords(Vr vr, std::string_view bytes, bool bigEndian);
// The value of a binary VR as text: values separated by backslashes. Empty for other VRs.
std::string textOfBinary(Vr vr, std::string_view bytes, bool bigEndian);

}  // namespace macula::dicom
