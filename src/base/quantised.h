// What floats become where only 16 bits can be drawn.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "base/volume.h"

namespace macula {

struct Quantised {
    std::shared_ptr<const Volume> volume;  // stored16
    bool isExact = true;                   // no value is another than before
};

// The volume itself when it has 16 bits, else a copy, padding apart as stored 0. Its steps divide the range
// of its values, or rangeToQuantise, to whose ends the values beyond it are brought. The copy's assumptions
// say both the largest error within that range and how many values lie beyond it. May throw std::bad_alloc.
Quantised quantised(std::shared_ptr<const Volume> volume);

// The range of the values; where a few voxels, at most one of ten thousand at either end, stretch it more
// than eightfold, that of the others, with as much again at that end. A metal or a division by almost zero
// must not take the steps away that tissue needs.
std::optional<ValueRange> rangeToQuantise(const Volume& volume);

}  // namespace macula
