// Adds messages that say why stacks were separated, to the stacks and to their series.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "dicom/messages/messages.h"
#include "dicom/stack/stack.h"

namespace macula::dicom {

void tellSplit(std::vector<Message>& messages, const std::vector<std::string>& names, std::size_t count);

// Reports that `count` phases were separated by the attribute `name`, `assumed` if that was a last resort.
void tellPhases(std::vector<Message>& messages, const std::string& name, bool assumed, std::size_t count);
void tellIncomplete(const std::vector<Stack>& phases, std::vector<Message>& messages);
void nameStackPhases(std::vector<Stack>& stacks, bool assumed);

// Adds the message to each of the stacks too, so that a volume made from one of them has it.
void tellAll(std::vector<Stack>& stacks, std::vector<Message>& messages, const Message& told);

}  // namespace macula::dicom
