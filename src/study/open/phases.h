// The volumes of a folder that show one thing at several times: phases of a heart, of a breath, of contrast.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/text.h"
#include "study/open/found_volumes.h"

namespace macula::study {

struct Phase {
    std::size_t volume = 0;  // among FoundVolumes::volumes()
    Text label;              // "trigger time 150 ms"; for the screen only
    // From the first phase, where the images say when they were taken.
    std::optional<double> atMs;

    bool operator==(const Phase&) const = default;
};

// All phases that the volume is one of, in their order; empty if it is none. They have one grid. They are the
// stacks of one series that imaged its positions several times (dicom::Stack::phases), or one volume each of
// at least three series of a study whose descriptions differ in a number only, and name a phase: by %,
// "phase", "gated", "resp" or "4D". Where descriptions are the only evidence, the labels are these.
std::vector<Phase> phasesOf(const FoundVolumes& found, std::size_t volume);

}  // namespace macula::study
