// Quantises float volumes for drawing, which needs 16 bits.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "base/volume.h"

namespace macula {

struct Quantised {
    std::shared_ptr<const Volume> volume;  // stored16
    bool isExact = true;                   // no value changed
};

// The volume itself when it has 16 bits, else a 16-bit copy, in which stored 0 is padding. The steps cover
// rangeToQuantise; values beyond it are clamped to its ends. The copy's assumptions state the largest error
// within that range, and its ends where values were clamped. May throw std::bad_alloc.
Quantised quantised(std::shared_ptr<const Volume> volume);

// The range of the values. Where at most one voxel of ten thousand at either end stretches it more than
// eightfold, the range of the others, widened by its width at each end: metal or a division by almost zero
// must not use up the steps that tissue needs.
std::optional<ValueRange> rangeToQuantise(const Volume& volume);

}  // namespace macula
