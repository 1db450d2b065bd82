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

    // Makes a stack of each part, labelled by its values of the attributes `names`.
    std::vector<Stack> stacksOf(const Stack& whole, const Partition& partition,
                                const std::vector<std::string>& names) const;
    // Adds one more stack, which is not a volume, for frames that nothing assigns to one of `stacks`.
    void addUnclear(const Stack& whole, std::vector<std::size_t> frames, std::vector<Stack>& stacks,
                    std::vector<Message>& messages) const;

  private:
    const std::string& modality_;
    const SplitRules& rules_;
};

}  // namespace macula::dicom
