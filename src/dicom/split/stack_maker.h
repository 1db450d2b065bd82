// Makes stacks of the parts into which a stack was divided.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "dicom/split/partition.h"
#include "dicom/stack/stack.h"

namespace macula::dicom {

Stack makeStack(std::vector<Frame> frames, std::vector<StackLabel> labels, const std::string& modality);

class StackMaker {
  public:
    // Keeps the references.
    StackMaker(const std::string& modality, const SplitRules& rules) : modality_(modality), rules_(rules) {}

    const std::string& modality() const { return modality_; }
    std::vector<std::string> namesOf(const std::vector<std::size_t>& attributes) const;

    // A stack of each part, called by its values of what `names` says.
    std::vector<Stack> stacksOf(const Stack& whole, const Partition& partition,
                                const std::vector<std::string>& names) const;
    // Puts frames of which nothing says where they belong beside the stacks, as one that is no volume.
    void addUnclear(const Stack& whole, std::vector<std::size_t> frames, std::vector<Stack>& stacks,
                    std::vector<Message>& messages) const;

  private:
    const std::string& modality_;
    const SplitRules& rules_;
};

}  // namespace macula::dicom
