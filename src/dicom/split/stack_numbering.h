// How the images of a stack are numbered along it (InstanceNumber, PS3.3 C.7.6.1), and which numbers nobody
// has.
#pragma once

#include <optional>
#include <set>

#include "dicom/stack/stack.h"

namespace macula::dicom {

// Numbers that rise or fall along the whole stack, by the same step in four of five places.
struct StackNumbering {
    int first = 0;  // of the first image along the slice normal
    int last = 0;
    int step = 1;  // from one image to the next; beyond 1 or -1 where others of the series have those between

    bool lowestIsFirst() const { return step > 0; }
    int lowest() const { return lowestIsFirst() ? first : last; }
    int highest() const { return lowestIsFirst() ? last : first; }
};

// Nothing for fewer than three images, those of multi-frame files (whose numbers are those of files), numbers
// in another order than the slices, or beyond 100 000.
std::optional<StackNumbering> numberingOf(const Stack& stack);

// The numbers that lie beyond `from` in steps of `by`, and that are not in `taken`: up to the next one that
// is, or down to 1.
struct NumbersBeyond {
    int count = 0;
    bool toTheBeginning = false;  // down to 1, and no other number lay between
    std::optional<int> another;   // the number of `taken` behind them
};
NumbersBeyond numbersBeyond(int from, int by, const std::set<int>& taken);

}  // namespace macula::dicom
