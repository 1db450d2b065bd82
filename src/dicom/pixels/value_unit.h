// What the values of a stack are measured in.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/volume.h"
#include "dicom/read/instance.h"

namespace macula::dicom {

struct ValueUnit {
    Unit unit = Unit::raw;
    std::string name;  // when unitSymbol(unit) is not it
};

// Of SUV, by what SUVType says (PS3.3 C.8.9.1.1.3).
inline constexpr std::string_view kGramsPerMillilitre = "g/mL";

// Raw when the frames name no unit, or different ones.
ValueUnit valueUnit(std::string_view modality, std::span<const Frame> frames);

// Why values of CT are no Hounsfield units; empty when they are: each image has a rescale slope and intercept
// (or lookup table) whose type is HU, or names no type in a CT image of more than 8 bits (PS3.3 C.8.2.1,
// C.11.1.1.2). Captures and images without a rescale are not guessed at.
std::string whyNoHounsfield(std::span<const Frame> frames);

}  // namespace macula::dicom
