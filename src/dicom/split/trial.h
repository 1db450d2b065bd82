// Grades the parts of a stack as stacks, without making them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "dicom/split/partition.h"
#include "dicom/stack/stack.h"

namespace macula::dicom {

// The quality of frames as one volume. An irregular one has slices interpolated between frames that may not
// belong together; a gapped one is even with slices missing.
enum class Grade { none, irregular, gapped, even };

Grade gradeOf(const Stack& stack);

struct Trial {
    Grade grade = Grade::none;
    std::size_t frames = 0;
    double lowMm = 0.0;  // extent along the normal of the first of all frames
    double highMm = 0.0;
};

std::vector<Trial> tryOut(std::span<const Frame> frames, const Partition& partition);

// Whether one part begins before another has ended.
bool interleave(std::vector<Trial> parts);
// Whether the parts are volumes of grade `least` or better, except for leftovers that are small compared with
// the largest.
bool areVolumes(std::span<const Trial> parts, Grade least);
// Whether at least half of the parts are volumes with frames at three quarters of the positions: one place
// was imaged repeatedly, rather than two places that overlap.
bool arePhases(std::span<const Trial> parts, std::size_t positions);

// Whether the parts are better than the whole stack. `least`: the grade that parts must have if the stack is
// irregular or no volume.
bool isBetter(const Stack& whole, const Partition& partition, Grade least);

}  // namespace macula::dicom
