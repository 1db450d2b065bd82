// Looks up data elements by their tags in DCMTK's data dictionary.
#pragma once

#include <string_view>

#include "dicom/read/tags.h"

namespace macula::dicom {

// A value representation, PS3.5 6.2: its two letters.
using Vr = std::uint16_t;

constexpr Vr vrOf(const char (&name)[3]) {
    return static_cast<Vr>(static_cast<unsigned char>(name[0]) << 8 | static_cast<unsigned char>(name[1]));
}

// Stands for US or SS, where the sign depends on the image. Where the dictionary leaves other VRs open, the
// VR is the wider one (OW).
inline constexpr Vr kVrUnsignedOrSigned = vrOf("xs");

// The VR of an element, 0 when unknown. The creator of a private element is needed to know it (PS3.5 7.8.1).
// Thread-safe.
Vr dictionaryVr(Tag tag, std::string_view privateCreator = {});

// Whether DCMTK found its dictionary (dicom.dic), which reading implicit VR needs.
bool hasDictionary();

}  // namespace macula::dicom
