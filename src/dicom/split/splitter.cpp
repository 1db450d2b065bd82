#include "dicom/split/splitter.h"

#include <algorithm>
#include <numeric>

#include "dicom/split/acquisitions.h"
#include "dicom/split/frame_order.h"
#include "dicom/stack/odd_images.h"

namespace macula::dicom {

namespace {

// Whether the fault is one that separating frames cannot mend: it would only multiply the message.
bool isHopeless(const Stack& stack) {
    return std::any_of(stack.messages.begin(), stack.messages.end(), [](const Message& m) {
        return m.severity >= Severity::blocksVolume && m.key != key::kDuplicatePositions &&
               m.key != key::kMissingSlices && m.key != key::kSpacingTooIrregular &&
               m.key != key::kNotReconstructable;
    });
}

// Slices of MR that do not overlap are acquired in several passes as a matter of course, the odd ones and the
// even ones, so that none disturbs its neighbour.
bool isAcquiredInterleaved(const Stack& whole) {
    if (whole.modality != "MR" || gradeOf(whole) == Grade::none) return false;
    constexpr double kRounding = 1.01;
    const double extentMm = glm::length(*whole.lastPositionMm - *whole.firstPositionMm);
    const double distanceMm = extentMm / double(whole.frames.size() - 1);
    return std::all_of(whole.frames.begin(), whole.frames.end(), [&](const Frame& f) {
        return f.sliceThicknessMm && *f.sliceThicknessMm <= kRounding * distanceMm;
    });
}

// Maps the parts of `finer`, which divide the frames of `coarse`, to frames of the whole.
Partition within(const Part& coarse, const Partition& finer) {
    Partition result = finer;
    for (Part& part : result) {
        part.values.insert(part.values.begin(), coarse.values.begin(), coarse.values.end());
        for (std::size_t& index : part.frames) index = coarse.frames[index];
    }
    return result;
}

// Whether frames of one time are slices side by side, as those of the largest part are, and not some images
// of here and there.
bool isAcquisition(const Trial& run, const Trial& largest) {
    constexpr std::size_t kLeastSlices = 4;
    constexpr double kMostTimesStep = 1.5;
    const auto stepMm = [](const Trial& t) { return (t.highMm - t.lowMm) / double(t.frames - 1); };
    return run.frames >= kLeastSlices && run.grade != Grade::none &&
           stepMm(run) <= kMostTimesStep * stepMm(largest);
}

void tellSplit(std::vector<Message>& messages, const std::vector<std::string>& names, std::size_t count) {
    std::string list = names.front();
    for (std::size_t i = 1; i < names.size(); ++i) list += " and " + names[i];
    messages.push_back(message(key::kSplitSeries, {{"attributes", list}, {"count", std::int64_t(count)}}));
}

void tellIncomplete(const std::vector<Stack>& phases, std::vector<Message>& messages) {
    std::size_t most = 0;
    for (const Stack& phase : phases) most = std::max(most, phase.frames.size());
    const auto fewer = std::count_if(phases.begin(), phases.end(),
                                     [&](const Stack& phase) { return phase.frames.size() < most; });
    if (fewer == 0) return;
    messages.push_back(message(key::kIncompletePhases,
                               {{"count", std::int64_t(fewer)}, {"total", std::int64_t(phases.size())}}));
}

void nameStackPhases(std::vector<Stack>& stacks, bool assumed) {
    for (std::size_t i = 0; i < stacks.size(); ++i) {
        stacks[i].phase = static_cast<int>(i);
        stacks[i].phases = static_cast<int>(stacks.size());
        if (assumed) {
            stacks[i].assumptions.emplace_back(
                "Images at one position were told apart by the order of their numbers.");
        }
    }
}

std::string numbersOf(const Stack& whole, const std::vector<std::size_t>& frames) {
    std::vector<const Frame*> named;
    for (const std::size_t frame : frames) named.push_back(&whole.frames[frame]);
    return describeNumbers(named);
}

// Says it of each of the stacks, too, so that it goes with the volume.
void tellAll(std::vector<Stack>& stacks, std::vector<Message>& messages, const Message& told) {
    for (Stack& stack : stacks) stack.assumptions.push_back(told.sentence);
    messages.push_back(told);
}

}  // namespace

Stack makeStack(std::vector<Frame> frames, std::vector<StackLabel> labels, const std::string& modality) {
    Stack stack;
    stack.frames = std::move(frames);
    stack.splitBy = std::move(labels);
    stack.modality = modality;
    assess(stack, modality);
    return stack;
}

Splitter::PhasesAsked Splitter::groupOf(const SplitRules::Phase& rule) {
    if (rule.assumed) return PhasesAsked::last;
    return rule.first ? PhasesAsked::first : PhasesAsked::then;
}

std::vector<Stack> Splitter::split(std::vector<Frame> frames, std::vector<StackLabel> labels,
                                   std::vector<Message>& messages) const {
    const auto one = [](Stack stack) {
        std::vector<Stack> stacks;
        stacks.push_back(std::move(stack));
        return stacks;
    };
    Stack whole = makeStack(std::move(frames), std::move(labels), modality_);
    if (whole.frames.size() < 2 || cancel_.cancelled() || isHopeless(whole)) return one(std::move(whole));
    const Message* why = whole.whyNoVolume();
    const bool repeats = (why != nullptr && why->key == key::kDuplicatePositions) ||
                         (gradeOf(whole) != Grade::even && placeToleranceMm(whole.frames) > kSamePositionMm);
    if (gradeOf(whole) != Grade::even) {
        if (auto parts = byPhases(whole, PhasesAsked::first, messages)) return std::move(*parts);
    }
    if (auto parts = separated(whole, repeats, messages)) return std::move(*parts);
    if (repeats) {
        if (auto parts = ofRepeats(whole, messages)) return std::move(*parts);
    }
    if (gradeOf(whole) != Grade::none) return one(std::move(whole));
    if (auto parts = atGaps(whole, messages)) return std::move(*parts);
    return one(std::move(whole));
}

// Parts that are even, or lack slices, come before parts in which slices would be interpolated between frames
// of several acquisitions.
Splitter::Stacks Splitter::separated(const Stack& whole, bool repeats, Messages& messages) const {
    for (const Grade least : {Grade::gapped, Grade::irregular}) {
        if (auto parts = bySoftAttributes(whole, least, messages)) return parts;
        if (repeats) continue;
        if (auto parts = byRuns(whole, least, messages)) return parts;
        if (least == Grade::irregular) break;
        if (auto parts = byWays(whole, messages)) return parts;
        if (auto parts = byLattices(whole, messages)) return parts;
    }
    return {};
}

Splitter::Stacks Splitter::ofRepeats(const Stack& whole, Messages& messages) const {
    using Asked = PhasesAsked;
    if (auto parts = byPhases(whole, Asked::then, messages)) return parts;
    if (auto parts = byRuns(whole, Grade::gapped, messages)) return parts;
    for (const Asked asked : {Asked::first, Asked::then, Asked::last}) {
        if (auto parts = bySoftAttributesAndPhases(whole, asked, messages)) return parts;
    }
    if (auto parts = byLattices(whole, messages)) return parts;
    if (auto parts = byPhases(whole, Asked::last, messages)) return parts;
    return byRepetition(whole, messages);
}

std::vector<Stack> Splitter::stacksOf(const Stack& whole, const Partition& partition,
                                      const std::vector<std::string>& names) const {
    std::vector<Stack> stacks;
    for (const Part& part : partition) {
        std::vector<Frame> frames;
        for (const std::size_t index : part.frames) frames.push_back(whole.frames[index]);
        std::vector<StackLabel> labels = whole.splitBy;
        for (std::size_t i = 0; i < names.size(); ++i) labels.push_back({names[i], part.values[i]});
        stacks.push_back(makeStack(std::move(frames), std::move(labels), modality_));
    }
    return stacks;
}

// Soft attributes in which the frames differ, one and two at a time, as in magnitude and phase images of
// two echoes.
std::vector<std::vector<std::size_t>> Splitter::softCandidates(const Stack& whole) const {
    std::vector<std::size_t> varying;
    for (const SplitRules::Soft& rule : rules_.soft) {
        if (!rule.modality.empty() && rule.modality != modality_) continue;
        if (whole.isEven() && !rule.evenToo) continue;
        if (rule.interleavable && isAcquiredInterleaved(whole)) continue;
        const Partition partition = partitionByValue(whole.frames, rules_, {rule.attribute});
        if (partition.size() > 1 && !separatesNothing(whole, partition)) varying.push_back(rule.attribute);
    }
    std::vector<std::vector<std::size_t>> candidates;
    for (const std::size_t attribute : varying) candidates.push_back({attribute});
    for (std::size_t i = 0; i < varying.size(); ++i) {
        for (std::size_t j = i + 1; j < varying.size(); ++j) candidates.push_back({varying[i], varying[j]});
    }
    return candidates;
}

// Images of an even volume of which some lack a value that all others share are not of two kinds.
bool Splitter::separatesNothing(const Stack& whole, const Partition& partition) const {
    return whole.isEven() && partition.size() == 2 &&
           std::ranges::any_of(partition, [](const Part& part) { return part.values.front().empty(); });
}

std::vector<std::string> Splitter::namesOf(const std::vector<std::size_t>& attributes) const {
    std::vector<std::string> names;
    for (const std::size_t attribute : attributes) names.push_back(rules_.attributes[attribute].name);
    return names;
}

Splitter::Stacks Splitter::bySoftAttributes(const Stack& whole, Grade least, Messages& messages) const {
    for (const auto& attributes : softCandidates(whole)) {
        if (!spend(whole.frames.size())) break;
        const Partition partition = partitionByValue(whole.frames, rules_, attributes);
        if (partition.size() > whole.frames.size() / 2) continue;  // single slices are no volumes
        if (!isBetter(whole, partition, least)) continue;
        const auto names = namesOf(attributes);
        tellSplit(messages, names, partition.size());
        return stacksOf(whole, partition, names);
    }
    return {};
}

// Two or more acquisitions at interleaved positions, or that overlap, one after the other.
Splitter::Stacks Splitter::byRuns(const Stack& whole, Grade least, Messages& messages) const {
    for (const std::size_t attribute : rules_.runs) {
        Partition runs = runsOf(whole, attribute, least);
        if (!runs.empty()) return asAcquisitions(whole, std::move(runs), attribute, messages);
    }
    return {};
}

// Divides a stack by gaps between its times into the fewest runs that make better volumes than the whole
// does, and each run again: two of three acquisitions may make an even volume together.
Partition Splitter::runsOf(const Stack& whole, std::size_t attribute, Grade least) const {
    constexpr std::size_t kMostRuns = 12;
    // Odd and even slices of MR are often acquired in turn.
    if (whole.modality == "MR" && gradeOf(whole) >= Grade::gapped) return {};
    const auto times = orderValues(whole.frames, rules_, attribute);
    for (std::size_t count = 2; count <= kMostRuns; ++count) {
        const Partition partition = partitionByRuns(times, count);
        if (partition.empty() || partition.size() > whole.frames.size() / 2) return {};
        if (!spend(whole.frames.size())) return {};
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

// The runs of one run, or it alone.
Partition Splitter::runsWithin(const Stack& whole, const Part& run, std::size_t attribute) const {
    // Frames of a volume keep the order that they have along the whole stack.
    if (tryOut(whole.frames, {run}).front().grade == Grade::none) return {run};
    std::vector<Frame> frames;
    for (const std::size_t index : run.frames) frames.push_back(whole.frames[index]);
    const Partition finer = runsOf(makeStack(std::move(frames), {}, modality_), attribute, Grade::gapped);
    return finer.empty() ? Partition{run} : within(run, finer);
}

// Stacks of runs. Images that were made once more, one by one, are a run of nothing.
std::vector<Stack> Splitter::asAcquisitions(const Stack& whole, Partition runs, std::size_t attribute,
                                            Messages& messages) const {
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
    std::vector<Stack> stacks = stacksOf(whole, acquisitions, namesOf({attribute}));
    const Positions positions = positionsOf(whole.frames, placeToleranceMm(whole.frames));
    if (positions.groups.size() < whole.frames.size() &&
        arePhases(tryOut(whole.frames, acquisitions), positions.groups.size())) {
        nameStackPhases(stacks, false);
        tellPhases(messages, {.attribute = attribute}, stacks.size());
        tellIncomplete(stacks, messages);
    } else {
        tellSplit(messages, namesOf({attribute}), stacks.size());
    }
    addUnclear(whole, std::move(unclear), stacks, messages);
    return stacks;
}

// Separates acquisitions that only the order of their image numbers tells apart.
Splitter::Stacks Splitter::byWays(const Stack& whole, Messages& messages) const {
    const bool isVolume = gradeOf(whole) >= Grade::gapped;
    if (whole.modality == "MR") return {};
    Partition partition = partitionByWays(whole.frames);
    if (partition.empty() || partition.size() > whole.frames.size() / 3) return {};
    if (isVolume && 2 * alternations(whole.frames, partition) <= whole.frames.size()) return {};
    if (!interleave(tryOut(whole.frames, partition)) || !isBetter(whole, partition, Grade::gapped)) return {};
    for (Part& part : partition) part.values = {numbersOf(whole, part.frames)};
    std::vector<Stack> stacks = stacksOf(whole, partition, {"InstanceNumber"});
    tellAll(stacks, messages, message(key::kSplitByNumber, {{"count", std::int64_t(partition.size())}}));
    return stacks;
}

// Acquisitions of which nothing but their positions tells: these lie at multiples of one distance.
Splitter::Stacks Splitter::byLattices(const Stack& whole, Messages& messages) const {
    if (whole.isEven()) return {};
    const Partition partition = separateLattices(whole.frames);
    if (partition.empty() || !interleave(tryOut(whole.frames, partition))) return {};
    if (!isBetter(whole, partition, Grade::gapped)) return {};
    // A volume that lacks slices is no two, unless it lacked every third throughout.
    const std::size_t count = alternations(whole.frames, partition);
    if (gradeOf(whole) == Grade::gapped && count + 1 < whole.frames.size()) return {};
    std::vector<Stack> stacks = stacksOf(whole, partition, {"Positions"});
    const double offsetMm = glm::length(*stacks[1].firstPositionMm - *stacks[0].firstPositionMm);
    messages.push_back(message(key::kInterleavedPositions,
                               {{"count", std::int64_t(stacks.size())}, {"offsetMm", offsetMm}}));
    return stacks;
}

Phases Splitter::phasesOf(const std::vector<Frame>& frames, const SplitRules::Phase& rule) const {
    if (rule.by == SplitRules::Phase::By::value)
        return {.parts = partitionByValue(frames, rules_, {rule.attribute}), .unclear = {}, .byNumber = {}};
    auto phases = phasesByRank(
        frames, rule.assumed ? instanceNumbers(frames) : orderValues(frames, rules_, rule.attribute));
    if (!phases) return {};
    for (Part& part : phases->parts) part.values = {frames[part.frames.front()].attributes[rule.attribute]};
    return std::move(*phases);
}

// Puts frames of which nothing says where they belong beside the stacks, as one that is no volume.
void Splitter::addUnclear(const Stack& whole, std::vector<std::size_t> frames, std::vector<Stack>& stacks,
                          Messages& messages) const {
    if (frames.empty()) return;
    std::ranges::sort(frames);
    const std::string numbers = numbersOf(whole, frames);
    tellAll(stacks, messages, message(key::kUnclearAcquisition, {{"numbers", numbers}}));
    Stack stack = std::move(stacksOf(whole, {{{"not clear"}, std::move(frames)}}, {"Acquisition"}).front());
    if (stack.canBeVolume()) {
        stack.messages.push_back(
            message(key::kUnclearAcquisition, Severity::blocksVolume, {{"numbers", numbers}}));
    }
    stacks.push_back(std::move(stack));
}

Splitter::Stacks Splitter::asPhases(const Stack& whole, const SplitRules::Phase& rule, Phases phases,
                                    Messages& messages) const {
    const Positions positions = positionsOf(whole.frames, placeToleranceMm(whole.frames));
    const std::vector<Trial> trials = tryOut(whole.frames, phases.parts);
    if (!areVolumes(trials, Grade::gapped)) return {};
    const std::string& name = rules_.attributes[rule.attribute].name;
    const bool areReal = arePhases(trials, positions.groups.size());
    // What only overlaps is no phase, and a time of its own does not make an image one.
    const bool haveLeftovers =
        std::ranges::any_of(trials, [](const Trial& trial) { return trial.grade == Grade::none; });
    const bool isValue = rule.by == SplitRules::Phase::By::value;
    if (!areReal && (!isValue || haveLeftovers || !interleave(trials))) return {};
    if (isValue && !rule.first && haveLeftovers) return {};
    std::vector<Stack> stacks = stacksOf(whole, phases.parts, {name});
    if (!areReal) {
        tellSplit(messages, {name}, stacks.size());
        return stacks;
    }
    nameStackPhases(stacks, rule.assumed);
    tellPhases(messages, rule, stacks.size());
    tellIncomplete(stacks, messages);
    if (!phases.byNumber.empty()) {
        tellAll(stacks, messages,
                message(key::kPhasesByNumber,
                        {{"attribute", name}, {"numbers", numbersOf(whole, phases.byNumber)}}));
    }
    addUnclear(whole, std::move(phases.unclear), stacks, messages);
    return stacks;
}

Splitter::Stacks Splitter::byPhases(const Stack& whole, PhasesAsked asked, Messages& messages) const {
    for (const SplitRules::Phase& rule : rules_.phases) {
        if (groupOf(rule) != asked || cancel_.cancelled()) continue;
        Phases phases = phasesOf(whole.frames, rule);
        if (phases.parts.size() < 2 || phases.parts.size() > whole.frames.size() / 2) continue;
        if (auto stacks = asPhases(whole, rule, std::move(phases), messages)) return stacks;
    }
    return {};
}

void Splitter::tellPhases(Messages& messages, const SplitRules::Phase& rule, std::size_t count) const {
    messages.push_back(
        message(rule.assumed ? key::kPhasesAssumed : key::kPhases,
                {{"count", std::int64_t(count)}, {"attribute", rules_.attributes[rule.attribute].name}}));
}

// Several phases in each of several reconstructions.
Splitter::Stacks Splitter::bySoftAttributesAndPhases(const Stack& whole, PhasesAsked asked,
                                                     Messages& messages) const {
    for (const auto& attributes : softCandidates(whole)) {
        const Partition coarse = partitionByValue(whole.frames, rules_, attributes);
        if (coarse.size() > whole.frames.size() / 4) continue;
        for (const SplitRules::Phase& rule : rules_.phases) {
            if (groupOf(rule) != asked) continue;
            if (!spend(whole.frames.size())) return {};
            std::vector<Stack> all;
            Messages told;
            std::size_t most = 0;
            bool isPartition = true;
            for (const Part& part : coarse) {
                std::vector<Frame> frames;
                for (const std::size_t index : part.frames) frames.push_back(whole.frames[index]);
                Phases finer = phasesOf(frames, rule);
                isPartition = isPartition && !finer.parts.empty();
                if (!isPartition) break;
                const auto toWhole = [&](std::vector<std::size_t>& places) {
                    for (std::size_t& place : places) place = part.frames[place];
                };
                finer.parts = within(part, finer.parts);
                toWhole(finer.unclear);
                toWhole(finer.byNumber);
                isPartition = areVolumes(tryOut(whole.frames, finer.parts), Grade::gapped);
                if (!isPartition) break;
                auto names = namesOf(attributes);
                names.push_back(rules_.attributes[rule.attribute].name);
                std::vector<Stack> made = stacksOf(whole, finer.parts, names);
                nameStackPhases(made, rule.assumed);
                most = std::max(most, made.size());
                addUnclear(whole, std::move(finer.unclear), made, told);
                for (Stack& stack : made) all.push_back(std::move(stack));
            }
            if (!isPartition || most < 2 || all.size() > whole.frames.size() / 2) continue;
            tellSplit(messages, namesOf(attributes), coarse.size());
            tellPhases(messages, rule, most);
            tellIncomplete(all, messages);
            messages.insert(messages.end(), told.begin(), told.end());
            return all;
        }
    }
    return {};
}

Splitter::Stacks Splitter::byRepetition(const Stack& whole, Messages& messages) const {
    const Partition partition = separateRepetitions(whole.frames);
    if (partition.size() != 2) return {};
    // Many repetitions are no slip, and which of them belong together is for a person to say.
    if (5 * partition[1].frames.size() > partition[0].frames.size()) return {};
    std::vector<Stack> stacks = stacksOf(whole, partition, {"Repetition"});
    if (!stacks[0].canBeVolume()) return {};
    const Message told = message(key::kRepeatedSlices, {{"count", std::int64_t(partition[1].frames.size())}});
    stacks[0].messages.push_back(told);
    stacks[0].assumptions.push_back(told.sentence);
    if (stacks[1].canBeVolume()) {
        stacks[1].messages.push_back(message(key::kRepeatedSlices, Severity::blocksVolume,
                                             {{"count", std::int64_t(partition[1].frames.size())}}));
    }
    messages.push_back(told);
    return stacks;
}

// Separates two body regions in one series.
Splitter::Stacks Splitter::atGaps(const Stack& whole, Messages& messages) const {
    const std::string& why = whole.whyNoVolume()->key;
    if (why != key::kMissingSlices && why != key::kSpacingTooIrregular) return {};
    const Partition partition = separateAtGaps(whole.frames);
    if (partition.size() < 2) return {};
    if (!areVolumes(tryOut(whole.frames, partition), Grade::irregular)) return {};
    std::vector<Stack> stacks = stacksOf(whole, partition, {"Block"});
    double gapMm = 0.0;
    for (std::size_t i = 1; i < stacks.size(); ++i) {
        gapMm = std::max(gapMm, glm::length(stacks[i].frames.front().plane->positionMm -
                                            stacks[i - 1].frames.back().plane->positionMm));
    }
    messages.push_back(
        message(key::kSeparateBlocks, {{"count", std::int64_t(stacks.size())}, {"gapMm", gapMm}}));
    return stacks;
}

// Thousands of frames that differ in everything must not cost minutes; they end as a question.
bool Splitter::spend(std::size_t frames) const {
    constexpr std::size_t kMostFramesTried = 1'000'000;
    tried_ += frames;
    return tried_ <= kMostFramesTried && !cancel_.cancelled();
}

}  // namespace macula::dicom
