// Text of DICOM files as UTF-8. PS3.3 C.12.1.1.2, PS3.5 6.1.
#pragma once

#include <string>
#include <string_view>

namespace macula::dicom {

// `declared` is SpecificCharacterSet as in the file, its values separated by backslashes. Always valid UTF-8.
std::string utf8Of(std::string_view text, std::string_view declared);

}  // namespace macula::dicom
