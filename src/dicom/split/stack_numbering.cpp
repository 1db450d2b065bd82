#include "dicom/split/stack_numbering.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <vector>

namespace macula::dicom {

namespace {

constexpr int kHighestNumber = 100'000;

// The numbers along the stack; nothing when an image has no usable number.
std::optional<std::vector<int>> numbersOf(const Stack& stack) {
    std::vector<int> numbers;
    numbers.reserve(stack.frames.size());
    for (const Frame& frame : stack.frames) {
        const Instance& instance = *frame.instance;
        if (instance.multiFrame || !instance.concatenationUid.empty() || !instance.instanceNumber) return {};
        if (std::abs(*instance.instanceNumber) > kHighestNumber) return {};
        numbers.push_back(*instance.instanceNumber);
    }
    return numbers;
}

}  // namespace

std::optional<StackNumbering> numberingOf(const Stack& stack) {
    constexpr std::size_t kFewest = 3;
    if (stack.frames.size() < kFewest) return {};
    const auto numbers = numbersOf(stack);
    if (!numbers) return {};
    std::map<int, std::size_t> steps;
    for (std::size_t i = 1; i < numbers->size(); ++i) ++steps[(*numbers)[i] - (*numbers)[i - 1]];
    const bool allRise = steps.begin()->first > 0;
    const bool allFall = steps.rbegin()->first < 0;
    if (!allRise && !allFall) return {};
    const auto usual = std::ranges::max_element(steps, {}, [](const auto& step) { return step.second; });
    if (5 * usual->second < 4 * (numbers->size() - 1)) return {};
    return StackNumbering{.first = numbers->front(), .last = numbers->back(), .step = usual->first};
}

NumbersBeyond numbersBeyond(int from, int by, const std::set<int>& taken) {
    NumbersBeyond beyond;
    if (by == 0) return beyond;
    // If other stacks have numbers between, only numbers that are a whole number of steps away count.
    const auto found = [&](int number) {
        if ((number - from) % by != 0) return false;
        beyond.count = (number - from) / by - 1;
        beyond.another = number;
        return true;
    };
    if (by > 0) {
        for (auto at = taken.upper_bound(from); at != taken.end(); ++at) {
            if (found(*at)) return beyond;
        }
        return beyond;  // no taken number is higher
    }
    for (auto at = taken.lower_bound(from); at != taken.begin();) {
        if (*--at < 1) break;
        if (found(*at)) return beyond;
    }
    beyond.count = std::max((from - 1) / -by, 0);
    beyond.toTheBeginning = beyond.count > 0;
    return beyond;
}

}  // namespace macula::dicom
