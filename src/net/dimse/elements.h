// The elements of a dataset that came over the network (PS3.5 chapter 7), without those in sequences. The
// walk does not recurse, and trusts no length: DCMTK's parser does both.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace macula::net {

enum class Encoding { implicitLittle, explicitLittle, explicitBig };

// Deflated datasets have none that could be walked through.
bool encodingOf(std::string_view transferSyntax, Encoding& encoding);

struct Element {
    std::uint32_t tag = 0;  // group and element
    std::span<const unsigned char> value;
};

// Calls `take` for each element, in order, until it returns false. Returns whether the bytes that it looked
// at are well-formed elements.
bool forEachElement(std::span<const unsigned char> bytes, Encoding encoding,
                    const std::function<bool(const Element&)>& take);

// The same for the elements in the items of those sequences that the dataset itself holds. Items are counted
// from 0, anew in each sequence.
struct ItemElement {
    std::uint32_t sequence = 0;  // its tag
    std::size_t item = 0;
    Element element;
};
bool forEachItemElement(std::span<const unsigned char> bytes, Encoding encoding,
                        std::span<const std::uint32_t> sequences,
                        const std::function<bool(const ItemElement&)>& take);

// The value without its padding.
std::string textOf(const Element& element);

}  // namespace macula::net
