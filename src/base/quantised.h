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

// Returns the volume itself when it has 16 bits, else a 16-bit copy, in which stored 0 is padding. The steps
// cover rangeToQuantise; values outside are clamped to its ends. The copy's assumptions state the largest
// error within that range, and its ends if values were clamped. May throw std::bad_alloc.
Quantised quantised(std::shared_ptr<const Volume> volume);

// The range to cover: normally that of all values. If the lowest and the highest 0.01 % of the voxels stretch
// it more than eightfold, it is the range of the other voxels, widened by its own width at each end: metal,
// or a division by almost zero, must not use up the steps that tissue needs.
std::optional<ValueRange> rangeToQuantise(const Volume& volume);

}  // namespace macula
