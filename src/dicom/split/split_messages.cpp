#include "dicom/split/split_messages.h"

#include <algorithm>

namespace macula::dicom {

void tellSplit(std::vector<Message>& messages, const std::vector<std::string>& names, std::size_t count) {
    Text list = Text::verbatim(names.front());
    for (std::size_t i = 1; i < names.size(); ++i) list = Text("{} and {}", std::move(list), names[i]);
    messages.push_back(message(key::kSplitSeries, {{"attributes", list}, {"count", std::int64_t(count)}}));
}

void tellIncomplete(const std::vector<Stack>& phases, std::vector<Message>& messages) {
    std::size_t most = 0;
    for (const Stack& phase : phases) most = std::max(most, phase.frames.size());
    const auto fewer = std::count_if(phases.begin(), phases.end(),
                                     [&](const Stack& phase) { return phase.frames.size() < most; });
    if (fewer == 0) return;
    messages.push_back(message(key::kIncompletePhases,
                               {{"count", std::int64_t(fewer)}, {"total", std::int64_t(phases.size())}}));
}

void nameStackPhases(std::vector<Stack>& stacks, bool assumed) {
    for (std::size_t i = 0; i < stacks.size(); ++i) {
        stacks[i].phase = static_cast<int>(i);
        stacks[i].phases = static_cast<int>(stacks.size());
        if (assumed) {
            stacks[i].assumptions.emplace_back(
                Text("Images at one position were told apart by the order of their numbers."));
        }
    }
}

void tellAll(std::vector<Stack>& stacks, std::vector<Message>& messages, const Message& told) {
    for (Stack& stack : stacks) stack.assumptions.push_back(told.sentence);
    messages.push_back(told);
}

void tellPhases(std::vector<Message>& messages, const std::string& name, bool assumed, std::size_t count) {
    messages.push_back(message(assumed ? key::kPhasesAssumed : key::kPhases,
                               {{"count", std::int64_t(count)}, {"attribute", name}}));
}

}  // namespace macula::dicom
