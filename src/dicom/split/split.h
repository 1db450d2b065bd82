// Splits the frames of a series into stacks, by the rules of split_rules.h.
#pragma once

#include <string>
#include <vector>

#include "base/progress.h"
#include "dicom/stack/split_rules.h"
#include "dicom/stack/stack.h"

namespace macula::dicom {

struct Split {
    std::vector<Stack> stacks;  // assessed; the phases of one volume are consecutive
    std::vector<Message> messages;
};

// Every frame is in exactly one stack. In this order:
//   - files that repeat a SOP Instance UID at the same position are moved to stacks of their own;
//   - hard attributes separate, and frames without a position from those with one; see hard_split.h;
//   - odd images (odd_images.h) become stacks of their own, and leave gaps in the others;
//   - frames at the same positions that name their phase are separated by it;
//   - one or two soft attributes separate a stack when the parts are volumes. They separate a volume only
//     into volumes that interleave or overlap, and an even one only when the rules name them for that;
//   - volumes that interleave or overlap are separated by runs of their times, by passes of their image
//     numbers along the normal, or by the lattices they lie on (acquisitions.h);
//   - a stack that is now a volume stays whole, with warnings where attributes change along its slices, or
//     where part of it was acquired apart;
//   - frames at the same positions are separated as phases, by value, or by ranks that agree along the stack
//     (phases.h); frames of unknown phase become a stack of their own, not a volume;
//   - of a few repeated positions the frames with the lowest number make the volume, and the rest are a stack
//     of their own;
//   - blocks that are far apart are separated at the gap;
//   - otherwise the stack stays whole, is not a volume, and its message asks a person.
// Deterministic: the order of `frames` does not matter. Once cancelled, it separates no further, and the
// caller must discard the result.
Split splitSeries(std::vector<Frame> frames, const std::string& modality, const SplitRules& rules,
                  const CancelToken& cancel = {});

}  // namespace macula::dicom
