// Says of stacks, and of their series, why they were separated.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "dicom/messages/messages.h"
#include "dicom/stack/stack.h"

namespace macula::dicom {

void tellSplit(std::vector<Message>& messages, const std::vector<std::string>& names, std::size_t count);

// That these phases were told apart by the attribute of that name, `assumed` as the last resort.
void tellPhases(std::vector<Message>& messages, const std::string& name, bool assumed, std::size_t count);
void tellIncomplete(const std::vector<Stack>& phases, std::vector<Message>& messages);
void nameStackPhases(std::vector<Stack>& stacks, bool assumed);

// Says it of each of the stacks, too, so that it goes with the volume.
void tellAll(std::vector<Stack>& stacks, std::vector<Message>& messages, const Message& told);

// The numbers of these frames of the stack, for a message.
Text describedNumbers(const Stack& whole, const std::vector<std::size_t>& frames);

}  // namespace macula::dicom
