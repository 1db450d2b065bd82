// An ICC profile of sRGB, made from its definition: presentation states must have one (PS3.3 C.11.15).
#pragma once

#include <cstdint>
#include <vector>

namespace macula::dicom {

// ICC.1:2010 (version 4.3), an input device profile of a matrix and three curves.
std::vector<std::uint8_t> srgbProfile();

}  // namespace macula::dicom
