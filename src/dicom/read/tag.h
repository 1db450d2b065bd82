// The tag of a data element.
#pragma once

#include <cstdint>

namespace macula::dicom {

// A tag, as listed in PS3.6.
struct Tag {
    std::uint16_t group;
    std::uint16_t element;

    bool operator==(const Tag&) const = default;
    std::uint32_t key() const { return std::uint32_t{group} << 16 | element; }
    bool isPrivate() const { return group % 2 == 1; }
};

}  // namespace macula::dicom
