#include "dicom/split/splitter.h"

#include <algorithm>

#include "dicom/split/acquisitions.h"
#include "dicom/split/frame_order.h"
#include "dicom/split/split_messages.h"
#include "dicom/stack/odd_images.h"

namespace macula::dicom {

namespace {

// Whether the stack has a fault that separating frames cannot mend: it would only multiply the message.
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

}  // namespace

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
    Stack whole = makeStack(std::move(frames), std::move(labels), maker_.modality());
    if (whole.frames.size() < 2 || budget_.isCancelled() || isHopeless(whole)) return one(std::move(whole));
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

// Prefers parts that are even or lack slices to parts in which slices would be interpolated between frames of
// several acquisitions.
Splitter::Stacks Splitter::separated(const Stack& whole, bool repeats, Messages& messages) const {
    for (const Grade least : {Grade::gapped, Grade::irregular}) {
        if (auto parts = bySoftAttributes(whole, least, messages)) return parts;
        if (repeats) continue;
        if (auto parts = runs_.split(whole, least, messages)) return parts;
        if (least == Grade::irregular) break;
        if (auto parts = byWays(whole, messages)) return parts;
        if (auto parts = byLattices(whole, messages)) return parts;
    }
    return {};
}

Splitter::Stacks Splitter::ofRepeats(const Stack& whole, Messages& messages) const {
    using Asked = PhasesAsked;
    if (auto parts = byPhases(whole, Asked::then, messages)) return parts;
    if (auto parts = runs_.split(whole, Grade::gapped, messages)) return parts;
    for (const Asked asked : {Asked::first, Asked::then, Asked::last}) {
        if (auto parts = bySoftAttributesAndPhases(whole, asked, messages)) return parts;
    }
    if (auto parts = byLattices(whole, messages)) return parts;
    if (auto parts = byPhases(whole, Asked::last, messages)) return parts;
    return byRepetition(whole, messages);
}

// Soft attributes in which the frames differ, one and two at a time, as in magnitude and phase images of
// two echoes.
std::vector<std::vector<std::size_t>> Splitter::softCandidates(const Stack& whole) const {
    std::vector<std::size_t> varying;
    for (const SplitRules::Soft& rule : rules_.soft) {
        if (!rule.modality.empty() && rule.modality != maker_.modality()) continue;
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

// Whether the partition is no reason to separate: in an even volume, images that lack a value which all
// others share are not of another kind.
bool Splitter::separatesNothing(const Stack& whole, const Partition& partition) const {
    return whole.isEven() && partition.size() == 2 &&
           std::ranges::any_of(partition, [](const Part& part) { return part.values.front().empty(); });
}

Splitter::Stacks Splitter::bySoftAttributes(const Stack& whole, Grade least, Messages& messages) const {
    for (const auto& attributes : softCandidates(whole)) {
        if (!budget_.spend(whole.frames.size())) break;
        const Partition partition = partitionByValue(whole.frames, rules_, attributes);
        if (partition.size() > whole.frames.size() / 2) continue;  // single slices are not volumes
        if (!isBetter(whole, partition, least)) continue;
        const auto names = maker_.namesOf(attributes);
        tellSplit(messages, names, partition.size());
        return maker_.stacksOf(whole, partition, names);
    }
    return {};
}

// Separates acquisitions that only the order of their image numbers tells apart.
Splitter::Stacks Splitter::byWays(const Stack& whole, Messages& messages) const {
    const bool isVolume = gradeOf(whole) >= Grade::gapped;
    if (whole.modality == "MR") return {};
    Partition partition = partitionByWays(whole.frames);
    if (partition.empty() || partition.size() > whole.frames.size() / 3) return {};
    if (isVolume && 2 * alternations(whole.frames, partition) <= whole.frames.size()) return {};
    if (!interleave(tryOut(whole.frames, partition)) || !isBetter(whole, partition, Grade::gapped)) return {};
    for (Part& part : partition) part.values = {describeNumbers(whole, part.frames).english()};
    std::vector<Stack> stacks = maker_.stacksOf(whole, partition, {"InstanceNumber"});
    tellAll(stacks, messages, message(key::kSplitByNumber, {{"count", std::int64_t(partition.size())}}));
    return stacks;
}

// Separates acquisitions that only their positions distinguish: each lies at multiples of one distance.
Splitter::Stacks Splitter::byLattices(const Stack& whole, Messages& messages) const {
    if (whole.isEven()) return {};
    const Partition partition = separateLattices(whole.frames);
    if (partition.empty() || !interleave(tryOut(whole.frames, partition))) return {};
    if (!isBetter(whole, partition, Grade::gapped)) return {};
    // A volume that lacks slices is not two volumes, unless every third slice is missing throughout.
    const std::size_t count = alternations(whole.frames, partition);
    if (gradeOf(whole) == Grade::gapped && count + 1 < whole.frames.size()) return {};
    std::vector<Stack> stacks = maker_.stacksOf(whole, partition, {"Positions"});
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

Splitter::Stacks Splitter::asPhases(const Stack& whole, const SplitRules::Phase& rule, Phases phases,
                                    Messages& messages) const {
    const Positions positions = positionsOf(whole.frames, placeToleranceMm(whole.frames));
    const std::vector<Trial> trials = tryOut(whole.frames, phases.parts);
    if (!areVolumes(trials, Grade::gapped)) return {};
    const std::string& name = rules_.attributes[rule.attribute].name;
    const bool areReal = arePhases(trials, positions.groups.size());
    // Parts that only overlap are not phases, and an image is not a phase just because it has its own time.
    const bool haveLeftovers =
        std::ranges::any_of(trials, [](const Trial& trial) { return trial.grade == Grade::none; });
    const bool isValue = rule.by == SplitRules::Phase::By::value;
    if (!areReal && (!isValue || haveLeftovers || !interleave(trials))) return {};
    if (isValue && !rule.first && haveLeftovers) return {};
    std::vector<Stack> stacks = maker_.stacksOf(whole, phases.parts, {name});
    if (!areReal) {
        tellSplit(messages, {name}, stacks.size());
        return stacks;
    }
    nameStackPhases(stacks, rule.assumed);
    tellPhases(messages, name, rule.assumed, stacks.size());
    tellIncomplete(stacks, messages);
    if (!phases.byNumber.empty()) {
        tellAll(stacks, messages,
                message(key::kPhasesByNumber,
                        {{"attribute", name}, {"numbers", describeNumbers(whole, phases.byNumber)}}));
    }
    maker_.addUnclear(whole, std::move(phases.unclear), stacks, messages);
    return stacks;
}

Splitter::Stacks Splitter::byPhases(const Stack& whole, PhasesAsked asked, Messages& messages) const {
    for (const SplitRules::Phase& rule : rules_.phases) {
        if (groupOf(rule) != asked || budget_.isCancelled()) continue;
        Phases phases = phasesOf(whole.frames, rule);
        if (phases.parts.size() < 2 || phases.parts.size() > whole.frames.size() / 2) continue;
        if (auto stacks = asPhases(whole, rule, std::move(phases), messages)) return stacks;
    }
    return {};
}

// Separates several phases in each of several reconstructions.
Splitter::Stacks Splitter::bySoftAttributesAndPhases(const Stack& whole, PhasesAsked asked,
                                                     Messages& messages) const {
    for (const auto& attributes : softCandidates(whole)) {
        const Partition coarse = partitionByValue(whole.frames, rules_, attributes);
        if (coarse.size() > whole.frames.size() / 4) continue;
        for (const SplitRules::Phase& rule : rules_.phases) {
            if (groupOf(rule) != asked) continue;
            if (!budget_.spend(whole.frames.size())) return {};
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
                auto names = maker_.namesOf(attributes);
                names.push_back(rules_.attributes[rule.attribute].name);
                std::vector<Stack> made = maker_.stacksOf(whole, finer.parts, names);
                nameStackPhases(made, rule.assumed);
                most = std::max(most, made.size());
                maker_.addUnclear(whole, std::move(finer.unclear), made, told);
                for (Stack& stack : made) all.push_back(std::move(stack));
            }
            if (!isPartition || most < 2 || all.size() > whole.frames.size() / 2) continue;
            tellSplit(messages, maker_.namesOf(attributes), coarse.size());
            tellPhases(messages, rules_.attributes[rule.attribute].name, rule.assumed, most);
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
    // Many repetitions are not an accident, and only a person can say which of them belong together.
    if (5 * partition[1].frames.size() > partition[0].frames.size()) return {};
    std::vector<Stack> stacks = maker_.stacksOf(whole, partition, {"Repetition"});
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
    std::vector<Stack> stacks = maker_.stacksOf(whole, partition, {"Block"});
    double gapMm = 0.0;
    for (std::size_t i = 1; i < stacks.size(); ++i) {
        gapMm = std::max(gapMm, glm::length(stacks[i].frames.front().plane->positionMm -
                                            stacks[i - 1].frames.back().plane->positionMm));
    }
    messages.push_back(
        message(key::kSeparateBlocks, {{"count", std::int64_t(stacks.size())}, {"gapMm", gapMm}}));
    return stacks;
}

}  // namespace macula::dicom
