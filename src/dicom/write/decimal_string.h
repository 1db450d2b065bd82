// Numbers as text: the VR DS of PS3.5 6.2.
#pragma once

#include <string>

namespace macula::dicom {

// The most exact text in at most 16 characters.
std::string decimalString(double value);

}  // namespace macula::dicom
