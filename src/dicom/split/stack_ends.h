// Where the slices of a stack end in the patient, and whether others go on there.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "dicom/stack/stack.h"

namespace macula::dicom {

enum class StackEnd { first, last };  // along the slice normal
inline constexpr std::array kStackEnds{StackEnd::first, StackEnd::last};

// The side of the patient that lies beyond an end: "head", "feet", "left", "right", "front" or "back". The
// stack has a geometry.
std::string_view sideBeyond(const Stack& stack, StackEnd end);

// The distance between slices, on average; 0 for one slice.
double stepMm(const Stack& stack);

// What another stack covers along the slice normal of this one, in mm from its first slice.
struct Reach {
    double firstMm = 0.0;
    double lastMm = 0.0;
};

// What `other`, parallel to `stack` and in its frame of reference, covers. Nothing for any other.
std::optional<Reach> reachOfParallel(const Stack& stack, const Stack& other);
// What the pictures of a localizer cover that lie across `stack`, in its frame of reference.
std::optional<Reach> reachOfLocalizer(const Stack& stack, const Stack& localizer);

// How far it goes on beyond an end of the stack; negative where it ends before.
double beyondMm(const Stack& stack, const Reach& reach, StackEnd end);

// Whether both stacks end at the same place, to a slice and a half.
bool endsAlike(const Stack& stack, const Stack& other, const Reach& reach, StackEnd end);

}  // namespace macula::dicom
