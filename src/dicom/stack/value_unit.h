// The unit of the values of a stack.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/text.h"
#include "base/volume.h"
#include "dicom/stack/instance.h"

namespace macula::dicom {

struct ValueUnit {
    Unit unit = Unit::raw;
    std::string name;  // if unitSymbol(unit) does not name it
};

// The unit of SUV, whose kind SUVType gives (PS3.3 C.8.9.1.1.3).
inline constexpr std::string_view kGramsPerMillilitre = "g/mL";

// Raw when the frames name no unit, or different ones. The name is "another unit" for a term that neither
// DICOM nor UCUM defines: it may be anything, even a person's name.
ValueUnit valueUnit(std::string_view modality, std::span<const Frame> frames);

// The unit's text for a sentence; empty when raw.
Text unitText(const ValueUnit& unit);

// The frame's own term for its unit, to compare frames by; empty when it has none, or an unspecified one. May
// be any text. "HU" for CT whose values are HU by definition.
std::string unitTerm(std::string_view modality, const Frame& frame);

// The reason why CT values are not Hounsfield units; empty when they are: each image has a rescale slope and
// intercept (or lookup table) whose type is HU, or names no type in a CT image of more than 8 bits (PS3.3
// C.8.2.1, C.11.1.1.2) whose ImageType does not say that it is a map of something else. Never assumed for
// captures and images without a rescale.
Text whyNoHounsfield(std::span<const Frame> frames);

}  // namespace macula::dicom
