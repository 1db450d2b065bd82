// From the frames of a series to its stacks, by the rules of split_rules.h.
#pragma once

#include <string>
#include <vector>

#include "base/progress.h"
#include "dicom/stack/split_rules.h"
#include "dicom/stack/stack.h"

namespace macula::dicom {

struct Split {
    std::vector<Stack> stacks;  // assessed; those of one volume's phases follow each other
    std::vector<Message> messages;
};

// Every frame is in exactly one stack. In this order:
//   - of files that share a SOP Instance UID and a position the first stays, and the others are stacks of
//     their own;
//   - hard attributes separate, and frames without a position from those with one; see hard_split.h;
//   - images that cannot be what they say (odd_images.h) are stacks of their own, and gaps in the others;
//   - frames at the same positions that name their phase are told apart by it;
//   - one or two soft attributes separate a stack when the parts are volumes. They separate a volume only
//     into volumes that interleave or overlap, and an even one only when the rules name them for that;
//   - volumes that interleave or overlap are separated by runs of their times, by the ways of their image
//     numbers along the normal, or by the lattices they lie on (acquisitions.h);
//   - what is a volume then is kept whole, and warned of where it changes along its slices, or where part of
//     it was acquired apart;
//   - frames at the same positions are told apart as phases, by value, or by ranks that agree along the stack
//     (phases.h); frames of which nothing says where they belong are a stack of their own and no volume;
//   - of a few repeated positions the frames with the lowest number make the volume, and the rest are a stack
//     of their own;
//   - far apart blocks are separated where the gap is;
//   - else the stack stays whole, is no volume, and its message asks.
// Deterministic: the order of `frames` does not matter. Once cancelled, nothing more is separated, and the
// result is to be thrown away.
Split splitSeries(std::vector<Frame> frames, const std::string& modality, const SplitRules& rules,
                  const CancelToken& cancel = {});

}  // namespace macula::dicom
