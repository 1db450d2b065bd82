#include "study/open/image_numbers.h"

#include <set>

namespace macula::study {

std::vector<int> imageNumbersOf(const dicom::Stack& stack, int slices) {
    if (slices < 1 || stack.slices.size() != std::size_t(slices)) return {};
    std::vector<int> numbers;
    std::set<int> seen;
    for (const dicom::SliceSource& slice : stack.slices) {
        if (slice.interpolated()) {
            numbers.push_back(0);
            continue;
        }
        if (slice.below >= stack.frames.size()) return {};
        const auto& instance = stack.frames[slice.below].instance;
        const int number = instance ? instance->instanceNumber.value_or(0) : 0;
        if (number < 1 || !seen.insert(number).second) return {};
        numbers.push_back(number);
    }
    return numbers;
}

bool countAsSlices(std::span<const int> imageNumbers) {
    for (std::size_t slice = 0; slice < imageNumbers.size(); ++slice) {
        if (imageNumbers[slice] != 0 && std::size_t(imageNumbers[slice]) != slice + 1) return false;
    }
    return true;
}

}  // namespace macula::study
