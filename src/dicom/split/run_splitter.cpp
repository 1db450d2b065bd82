#include "dicom/split/run_splitter.h"

#include <algorithm>
#include <utility>

#include "dicom/split/acquisitions.h"
#include "dicom/split/frame_order.h"
#include "dicom/split/split_messages.h"

namespace macula::dicom {

namespace {

// Whether the frames of a run are adjacent slices, as those of the largest run are, and not scattered images.
bool isAcquisition(const Trial& run, const Trial& largest) {
    constexpr std::size_t kLeastSlices = 4;
    constexpr double kMostTimesStep = 1.5;
    const auto stepMm = [](const Trial& t) { return (t.highMm - t.lowMm) / double(t.frames - 1); };
    return run.frames >= kLeastSlices && run.grade != Grade::none &&
           stepMm(run) <= kMostTimesStep * stepMm(largest);
}

}  // namespace

std::optional<std::vector<Stack>> RunSplitter::split(const Stack& whole, Grade least,
                                                     std::vector<Message>& messages) const {
    for (const std::size_t attribute : rules_.runs) {
        Partition runs = runsOf(whole, attribute, least);
        if (!runs.empty()) return asAcquisitions(whole, std::move(runs), attribute, messages);
    }
    return {};
}

// Divides a stack at pauses between its times into the fewest runs that are better volumes than the whole,
// and each run again: two of three acquisitions may make an even volume together.
Partition RunSplitter::runsOf(const Stack& whole, std::size_t attribute, Grade least) const {
    constexpr std::size_t kMostRuns = 12;
    // Odd and even slices of MR are often acquired in turn.
    if (whole.modality == "MR" && gradeOf(whole) >= Grade::gapped) return {};
    const auto times = orderValues(whole.frames, rules_, attribute);
    for (std::size_t count = 2; count <= kMostRuns; ++count) {
        const Partition partition = partitionByRuns(times, count);
        if (partition.empty() || partition.size() > whole.frames.size() / 2) return {};
        if (!budget_.spend(whole.frames.size())) return {};
        const bool alternate = 2 * alternations(whole.frames, partition) > whole.frames.size();
        if (gradeOf(whole) >= Grade::gapped && !alternate) continue;
        if (!isBetter(whole, partition, least) || !interleave(tryOut(whole.frames, partition))) continue;
        Partition all;
        for (const Part& part : partition) {
            const Partition finer = runsWithin(whole, part, attribute);
            all.insert(all.end(), finer.begin(), finer.end());
        }
        return all;
    }
    return {};
}

// Divides one run further, or returns it alone.
Partition RunSplitter::runsWithin(const Stack& whole, const Part& run, std::size_t attribute) const {
    // Only for a volume, because makeStack keeps the order of its frames, so that indices in `finer` fit.
    if (tryOut(whole.frames, {run}).front().grade == Grade::none) return {run};
    std::vector<Frame> frames;
    for (const std::size_t index : run.frames) frames.push_back(whole.frames[index]);
    const Partition finer =
        runsOf(makeStack(std::move(frames), {}, maker_.modality()), attribute, Grade::gapped);
    return finer.empty() ? Partition{run} : within(run, finer);
}

// Makes stacks of the runs. Images that were repeated one by one are not an acquisition.
std::vector<Stack> RunSplitter::asAcquisitions(const Stack& whole, Partition runs, std::size_t attribute,
                                               std::vector<Message>& messages) const {
    const std::vector<Trial> trials = tryOut(whole.frames, runs);
    const auto largest = std::ranges::max_element(trials, {}, &Trial::frames);
    std::vector<std::size_t> unclear;
    Partition acquisitions;
    for (std::size_t n = 0; n < runs.size(); ++n) {
        Part& run = runs[n];
        if (!isAcquisition(trials[n], *largest)) {
            unclear.insert(unclear.end(), run.frames.begin(), run.frames.end());
            continue;
        }
        run.values = {whole.frames[run.frames.front()].attributes[attribute]};
        acquisitions.push_back(std::move(run));
    }
    std::vector<Stack> stacks = maker_.stacksOf(whole, acquisitions, maker_.namesOf({attribute}));
    const Positions positions = positionsOf(whole.frames, placeToleranceMm(whole.frames));
    if (positions.groups.size() < whole.frames.size() &&
        arePhases(tryOut(whole.frames, acquisitions), positions.groups.size())) {
        nameStackPhases(stacks, false);
        tellPhases(messages, rules_.attributes[attribute].name, false, stacks.size());
        tellIncomplete(stacks, messages);
    } else {
        tellSplit(messages, maker_.namesOf({attribute}), stacks.size());
    }
    maker_.addUnclear(whole, std::move(unclear), stacks, messages);
    return stacks;
}

}  // namespace macula::dicom
