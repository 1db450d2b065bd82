// How many more ways of splitting may be tried.
#pragma once

#include <cstddef>

#include "base/progress.h"

namespace macula::dicom {

// Thousands of frames that differ in everything must not cost minutes; they end as a question.
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

}  // namespace macula::dicom
