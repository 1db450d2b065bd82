// Separates acquisitions of one stack by the pauses between their times.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "dicom/split/partition.h"
#include "dicom/split/stack_maker.h"
#include "dicom/split/trial.h"
#include "dicom/stack/stack.h"

namespace macula::dicom {

// How many more ways of splitting may be tried. Thousands of frames that differ in everything must not cost
// minutes; they end as a question.
class SplitBudget {
  public:
    // Keeps the reference.
    explicit SplitBudget(const CancelToken& cancel) : cancel_(cancel) {}

    bool isCancelled() const { return cancel_.cancelled(); }
    // Whether one more way may be tried with this many frames.
    bool spend(std::size_t frames) {
        constexpr std::size_t kMostFramesTried = 1'000'000;
        tried_ += frames;
        return tried_ <= kMostFramesTried && !isCancelled();
    }

  private:
    const CancelToken& cancel_;
    std::size_t tried_ = 0;
};

class RunSplitter {
  public:
    // Keeps the references.
    RunSplitter(const StackMaker& maker, const SplitRules& rules, SplitBudget& budget)
        : maker_(maker), rules_(rules), budget_(budget) {}

    // Separates two or more acquisitions that were made one after the other, and interleave or overlap;
    // nothing if there are none.
    std::optional<std::vector<Stack>> split(const Stack& whole, Grade least,
                                            std::vector<Message>& messages) const;

  private:
    Partition runsOf(const Stack& whole, std::size_t attribute, Grade least) const;
    Partition runsWithin(const Stack& whole, const Part& run, std::size_t attribute) const;
    std::vector<Stack> asAcquisitions(const Stack& whole, Partition runs, std::size_t attribute,
                                      std::vector<Message>& messages) const;

    const StackMaker& maker_;
    const SplitRules& rules_;
    SplitBudget& budget_;
};

}  // namespace macula::dicom
