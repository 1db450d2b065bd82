// The volumes of a folder or file that show one thing at several times: phases of a heart, of a breath, of
// contrast.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "base/text.h"
#include "study/open/found_volumes.h"
#include "study/open/opened_study.h"
#include "study/open/volumes_of_file.h"

namespace macula::study {

struct Phase {
    std::size_t volume = 0;  // among FoundVolumes::volumes(), or of VolumesOfFile
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

// Those of an open study: of its folder, or the volumes of its file.
std::vector<Phase> phasesOf(const OpenedStudy& study);

// Where the phases of a study are read from.
struct PhaseSource {
    std::shared_ptr<const FoundVolumes> found = {};
    std::shared_ptr<const VolumesOfFile> file = {};  // where `found` is null

    bool operator==(const PhaseSource&) const = default;
};
PhaseSource phaseSourceOf(const OpenedStudy& study);

// Decodes that phase alone. `source` is not empty. Throws nothing.
Result<OpenedStudy> openPhase(const PhaseSource& source, std::size_t volume, Progress& progress);

}  // namespace macula::study
