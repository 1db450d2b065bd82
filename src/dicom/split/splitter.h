// Splits frames that agree in all hard attributes into stacks: by their attributes, times and places.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "dicom/split/partition.h"
#include "dicom/split/phases.h"
#include "dicom/split/run_splitter.h"
#include "dicom/split/stack_maker.h"
#include "dicom/split/trial.h"
#include "dicom/stack/stack.h"

namespace macula::dicom {

// Tries one way after another, from explicit attributes to assumptions, in the order of split.h.
class Splitter {
  public:
    // Keeps the references.
    Splitter(const std::string& modality, const SplitRules& rules, const CancelToken& cancel)
        : maker_(modality, rules), rules_(rules), budget_(cancel), runs_(maker_, rules_, budget_) {}
    Splitter(const Splitter&) = delete;
    Splitter& operator=(const Splitter&) = delete;

    // Every frame is in exactly one stack. Messages are about the series.
    std::vector<Stack> split(std::vector<Frame> frames, std::vector<StackLabel> labels,
                             std::vector<Message>& messages) const;

  private:
    using Stacks = std::optional<std::vector<Stack>>;
    using Messages = std::vector<Message>;

    // The three groups of phase rules: explicit ones, those from times, and a guess.
    enum class PhasesAsked { first, then, last };

    static PhasesAsked groupOf(const SplitRules::Phase& rule);

    Stacks separated(const Stack& whole, bool repeats, Messages& messages) const;
    Stacks ofRepeats(const Stack& whole, Messages& messages) const;

    Stacks bySoftAttributes(const Stack& whole, Grade least, Messages& messages) const;
    Stacks byWays(const Stack& whole, Messages& messages) const;
    Stacks byLattices(const Stack& whole, Messages& messages) const;
    Stacks byPhases(const Stack& whole, PhasesAsked asked, Messages& messages) const;
    Stacks bySoftAttributesAndPhases(const Stack& whole, PhasesAsked asked, Messages& messages) const;
    Stacks byRepetition(const Stack& whole, Messages& messages) const;
    Stacks atGaps(const Stack& whole, Messages& messages) const;

    Stacks asPhases(const Stack& whole, const SplitRules::Phase& rule, Phases phases,
                    Messages& messages) const;
    Phases phasesOf(const std::vector<Frame>& frames, const SplitRules::Phase& rule) const;
    std::vector<std::vector<std::size_t>> softCandidates(const Stack& whole) const;
    bool separatesNothing(const Stack& whole, const Partition& partition) const;

    const StackMaker maker_;
    const SplitRules& rules_;
    mutable SplitBudget budget_;
    const RunSplitter runs_;
};

}  // namespace macula::dicom
