// Colours as DICOM writes them.
#pragma once

#include <array>
#include <cstdint>

namespace macula::dicom {

// Converts sRGB to CIELab, as three words (PS3.3 C.10.7.1.1). rgbOfCieLab makes the same colour of it.
std::array<std::uint16_t, 3> cieLabOfRgb(const std::array<std::uint8_t, 3>& rgb);

}  // namespace macula::dicom
