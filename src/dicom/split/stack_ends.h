// Finds where the slices of a stack end in the patient, and whether others continue there.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "base/text.h"
#include "dicom/stack/stack.h"

namespace macula::dicom {

enum class StackEnd { first, last };  // along the slice normal
inline constexpr std::array kStackEnds{StackEnd::first, StackEnd::last};

// The side of the patient that lies beyond an end: "head", "feet", "left", "right", "front" or "back". The
// stack has a geometry.
Text sideBeyond(const Stack& stack, StackEnd end);

// The distance between slices, on average; 0 for one slice.
double stepMm(const Stack& stack);

// The extent of another stack along the slice normal of this one, in mm from the first slice of this one.
struct Reach {
    double firstMm = 0.0;
    double lastMm = 0.0;
};

// The reach of `other`; nothing unless it is parallel to `stack` and in its frame of reference.
std::optional<Reach> reachOfParallel(const Stack& stack, const Stack& other);
// The reach of those images of a localizer that lie across `stack`, in its frame of reference.
std::optional<Reach> reachOfLocalizer(const Stack& stack, const Stack& localizer);

// How far `reach` extends beyond an end of the stack; negative if it ends before.
double beyondMm(const Stack& stack, const Reach& reach, StackEnd end);

// Whether both stacks end at the same place, within a slice and a half.
bool endsAlike(const Stack& stack, const Stack& other, const Reach& reach, StackEnd end);

}  // namespace macula::dicom
