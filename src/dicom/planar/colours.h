// The colours of a pixel (PS3.3 C.7.6.3.1.2), brought to red, green and blue of 8 bits. Pure functions.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "dicom/read/dataset.h"

namespace macula::dicom {

enum class ColourModel {
    rgb,
    ybrFull,     // luminance and colour differences of all 256 values (ITU-T T.871)
    ybrPartial,  // luminance from 16 to 235, differences from 16 to 240 (ITU-R BT.601); retired
};

// Nothing for grey, palettes, and what the standard retired long ago (HSV, ARGB, CMYK). The models of JPEG
// 2000 (YBR_ICT, YBR_RCT) are RGB: its decoder undoes them.
std::optional<ColourModel> colourModelOf(std::string_view photometricInterpretation);

// Three bytes for each pixel. `samples`: three for each pixel, of `bitsStored` bits, from 1 to 16.
std::vector<std::uint8_t> toRgb(ColourModel model, int bitsStored, std::span<const std::uint16_t> samples);

// PALETTE COLOR (PS3.3 C.7.9).
struct ColourPalette {
    int firstMapped = 0;
    std::vector<std::array<std::uint8_t, 3>> colours;  // not empty

    // Below and above the palette its first and last colour.
    const std::array<std::uint8_t, 3>& operator()(int raw) const;
};

// Nothing where a table is missing, or descriptor and data do not fit. Tables of 16 bits whose entries are
// all below 256 are read as 8 bits, which some writers mean.
std::optional<ColourPalette> readPalette(const Dataset& header, bool pixelsAreSigned);

}  // namespace macula::dicom
