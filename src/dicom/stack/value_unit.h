// What the values of a stack are measured in.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/volume.h"
#include "dicom/stack/instance.h"

namespace macula::dicom {

struct ValueUnit {
    Unit unit = Unit::raw;
    std::string name;  // when unitSymbol(unit) is not it
};

// Of SUV, by what SUVType says (PS3.3 C.8.9.1.1.3).
inline constexpr std::string_view kGramsPerMillilitre = "g/mL";

// Raw when the frames name no unit, or different ones. What is no term that DICOM or UCUM defines is not
// repeated, since it may be anything, a name too: then the name is "another unit".
ValueUnit valueUnit(std::string_view modality, std::span<const Frame> frames);

// The same for a sentence; empty when raw.
std::string unitText(const ValueUnit& unit);

// What the frame says its values are in, to compare frames by; empty when it does not say, or says that it is
// unspecified. May be any text. CT of which HU is the definition says HU.
std::string unitTerm(std::string_view modality, const Frame& frame);

// Why values of CT are no Hounsfield units; empty when they are: each image has a rescale slope and intercept
// (or lookup table) whose type is HU, or names no type in a CT image of more than 8 bits (PS3.3 C.8.2.1,
// C.11.1.1.2) whose ImageType does not say that it is a map of something else. Captures and images without a
// rescale are not guessed at.
std::string whyNoHounsfield(std::span<const Frame> frames);

}  // namespace macula::dicom
