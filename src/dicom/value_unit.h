// What the values of a stack are measured in.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/volume.h"
#include "dicom/instance.h"

namespace macula::dicom {

struct ValueUnit {
    Unit unit = Unit::raw;
    std::string name;  // when unitSymbol(unit) is not it
};

// Hounsfield units only for CT that says so, or says nothing (PS3.3 C.11.1.1.2); raw when the frames name
// none, or different ones.
ValueUnit valueUnit(std::string_view modality, std::span<const Frame> frames);

}  // namespace macula::dicom
