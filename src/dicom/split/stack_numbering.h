// Describes how images are numbered along a stack (InstanceNumber, PS3.3 C.7.6.1), and finds unused numbers.
#pragma once

#include <optional>
#include <set>

#include "dicom/stack/stack.h"

namespace macula::dicom {

// A numbering that rises or falls along the whole stack, by the same step in four of five places.
struct StackNumbering {
    int first = 0;  // number of the first image along the slice normal
    int last = 0;
    int step = 1;  // from one image to the next; not 1 or -1 if other stacks have numbers between

    bool lowestIsFirst() const { return step > 0; }
    int lowest() const { return lowestIsFirst() ? first : last; }
    int highest() const { return lowestIsFirst() ? last : first; }
};

// Nothing for fewer than three images, those of multi-frame files (whose numbers are those of files), numbers
// in another order than the slices, or beyond 100 000.
std::optional<StackNumbering> numberingOf(const Stack& stack);

// The numbers beyond `from` in steps of `by` up to the next one in `taken`, or down to 1; none if `taken` has
// no higher one.
struct NumbersBeyond {
    int count = 0;
    bool toTheBeginning = false;  // they go down to 1 without a taken number
    std::optional<int> another;   // the next number of `taken`
};
NumbersBeyond numbersBeyond(int from, int by, const std::set<int>& taken);

}  // namespace macula::dicom
