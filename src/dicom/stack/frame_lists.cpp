#include "dicom/stack/frame_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace macula::dicom {

namespace {

// Dimensions that say where a frame lies: position in the stack, stack, positions in the patient and in a
// volume, and the macros of both.
constexpr std::array kOfPlace = std::to_array<std::string_view>(
    {"(0020,9057)", "(0020,9056)", "(0020,0032)", "(0020,9301)", "(0020,9113)", "(0020,930E)"});

}  // namespace

FrameLists::FrameLists(const SplitRules& rules, const Dataset& header) {
    const auto frames = static_cast<std::size_t>(header.frameCount());
    for (std::size_t a = 0; a < rules.attributes.size(); ++a) {
        const Attribute& attribute = rules.attributes[a];
        if (attribute.reading == Attribute::Reading::dimensions) ofDimensions_.push_back(a);
        if (attribute.reading != Attribute::Reading::list) continue;
        std::vector<double> values = header.allNumbers(attribute.tags.front().tag);
        // The values of a list of another length cannot be assigned to frames.
        if (values.size() == frames) lists_.push_back({a, std::move(values)});
    }
    for (const Dataset& dimension : header.items(tag::kDimensionIndex)) {
        const std::string pointer = dimension.shortText(tag::kDimensionIndexPointer);
        isOfPlace_.push_back(std::ranges::find(kOfPlace, pointer) != kOfPlace.end());
    }
}

std::string FrameLists::indicesOf(const Dataset& frame) const {
    const std::vector<double> indices = frame.shortNumbers(tag::kDimensionIndexValues);
    std::string text;
    if (indices.size() != isOfPlace_.size()) return text;
    for (std::size_t d = 0; d < indices.size(); ++d) {
        if (!isOfPlace_[d]) text += fmt::format("{}{}", text.empty() ? "" : "\\", indices[d]);
    }
    return text;
}

void FrameLists::apply(const Dataset& frame, int number, std::vector<std::string>& attributes) const {
    for (const List& list : lists_)
        attributes[list.attribute] = fmt::format("{}", list.values[static_cast<std::size_t>(number)]);
    if (ofDimensions_.empty() || isOfPlace_.empty()) return;
    const std::string indices = indicesOf(frame);
    for (const std::size_t attribute : ofDimensions_) attributes[attribute] = indices;
}

bool FrameLists::mayHave(std::size_t attribute) const {
    return std::ranges::find(lists_, attribute, &List::attribute) != lists_.end() ||
           std::ranges::find(ofDimensions_, attribute) != ofDimensions_.end();
}

}  // namespace macula::dicom
