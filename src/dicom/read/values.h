// What the bytes of a data element say, by its value representation. PS3.5 6.2.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/parsing.h"
#include "dicom/read/dictionary.h"

namespace macula::dicom {

bool isTextVr(Vr vr);
// Text in the character set of the file (PS3.5 6.1.2.2); other text is in the default one.
bool usesCharacterSet(Vr vr);
std::vector<std::string_view> splitAtBackslash(std::string_view text);  // each trimmed

// The values of binary numbers; empty when the VR is none of these, or the length does not fit.
std::vector<double> binaryNumbers(Vr vr, std::string_view bytes, bool bigEndian);
// The words of any VR of 16 bits, and of bytes (two make one word).
std::vector<std::uint16_t> binaryWords(Vr vr, std::string_view bytes, bool bigEndian);
// The value of a binary VR as text: values separated by backslashes. Empty for bytes that are no numbers.
std::string textOfBinary(Vr vr, std::string_view bytes, bool bigEndian);

}  // namespace macula::dicom
