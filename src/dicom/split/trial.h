// How good the parts of a stack would be as stacks, found out without making them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "dicom/split/partition.h"
#include "dicom/stack/stack.h"

namespace macula::dicom {

// How good frames are as one volume. In an irregular one slices are interpolated between frames that may not
// belong together; a gapped one lacks slices of an even one.
enum class Grade { none, irregular, gapped, even };

Grade gradeOf(const Stack& stack);

struct Trial {
    Grade grade = Grade::none;
    std::size_t frames = 0;
    double lowMm = 0.0;  // extent along the normal of the first frame of all
    double highMm = 0.0;
};

std::vector<Trial> tryOut(std::span<const Frame> frames, const Partition& partition);

// Whether one part begins before another has ended.
bool interleave(std::vector<Trial> parts);
// Whether the parts are volumes of this grade or a better one, but for leftovers that are small against the
// largest.
bool areVolumes(std::span<const Trial> parts, Grade least);
// Whether most of the parts are volumes that cover three quarters of the positions: a place was imaged again
// and again, and not two places that overlap.
bool arePhases(std::span<const Trial> parts, std::size_t positions);

// Whether the parts are better than the stack as one. `least`: what parts have to be where the stack is
// irregular or no volume.
bool isBetter(const Stack& whole, const Partition& partition, Grade least);

}  // namespace macula::dicom
