// What is known of data elements by their tags: DCMTK's data dictionary.
#pragma once

#include <string_view>

#include "dicom/read/tag.h"

namespace macula::dicom {

// A value representation, PS3.5 6.2: its two letters.
using Vr = std::uint16_t;

constexpr Vr vrOf(const char (&name)[3]) {
    return static_cast<Vr>(static_cast<unsigned char>(name[0]) << 8 | static_cast<unsigned char>(name[1]));
}

// The VR for US or SS, where the sign depends on the image. Where else the dictionary leaves it open, it is
// the wider one (OW).
inline constexpr Vr kVrUnsignedOrSigned = vrOf("xs");

// The VR of an element, 0 when unknown. The creator of a private element is needed to know it (PS3.5 7.8.1).
// Thread-safe.
Vr dictionaryVr(Tag tag, std::string_view privateCreator = {});

// The toolkit found its dictionary (dicom.dic): without it nothing in implicit VR can be read.
bool hasDictionary();

}  // namespace macula::dicom
