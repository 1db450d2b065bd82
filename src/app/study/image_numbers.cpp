#include "app/study/image_numbers.h"

#include <set>

namespace macula::app {

std::vector<int> imageNumbersOf(const dicom::Stack& stack, int slices) {
    if (slices < 1 || stack.slices.size() != std::size_t(slices)) return {};
    std::vector<int> numbers;
    std::set<int> seen;
    bool areAsSlices = true;
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
        areAsSlices = areAsSlices && std::size_t(number) == numbers.size();
    }
    if (areAsSlices) return {};
    return numbers;
}

}  // namespace macula::app
