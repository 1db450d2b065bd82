#include "dicom/split/split.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "dicom/split/changes_along_stack.h"
#include "dicom/split/hard_split.h"
#include "dicom/split/odd_images.h"
#include "dicom/split/partition.h"

namespace macula::dicom {

namespace {

using Quality = StackGeometry::Quality;

Quality qualityOf(const Stack& stack) {
    if (!stack.canBeVolume()) return Quality::none;
    return stack.isEven() ? Quality::even : Quality::resampled;
}

Stack makeStack(std::vector<Frame> frames, std::vector<StackLabel> labels, const std::string& modality) {
    Stack stack;
    stack.frames = std::move(frames);
    stack.splitBy = std::move(labels);
    stack.modality = modality;
    assess(stack, modality);
    return stack;
}

// Whether the fault is one that separating frames cannot mend: it would only multiply the message.
bool isHopeless(const Stack& stack) {
    return std::any_of(stack.messages.begin(), stack.messages.end(), [](const Message& m) {
        return m.severity >= Severity::blocksVolume && m.key != key::kDuplicatePositions &&
               m.key != key::kMissingSlices && m.key != key::kSpacingTooIrregular &&
               m.key != key::kNotReconstructable;
    });
}

// What a part would be as a stack, found out without making it.
struct Trial {
    Quality quality = Quality::none;
    std::size_t frames = 0;
    double lowMm = 0.0;  // extent along the normal
    double highMm = 0.0;
};

std::vector<Trial> tryOut(const std::vector<Frame>& frames, const Partition& partition) {
    const glm::dvec3 normal = frames.front().plane->normal();
    std::vector<Trial> trials;
    for (const Part& part : partition) {
        std::vector<StackedPlane> planes;
        for (const std::size_t index : part.frames) planes.push_back({*frames[index].plane});
        const StackGeometry geometry = stackPlanes(planes);
        const auto along = [&](std::size_t place) {
            return glm::dot(planes[geometry.order[place]].plane.positionMm, normal);
        };
        trials.push_back({geometry.quality, planes.size(), along(0), along(planes.size() - 1)});
    }
    return trials;
}

bool interleave(std::vector<Trial> trials) {
    std::sort(trials.begin(), trials.end(), [](const Trial& a, const Trial& b) { return a.lowMm < b.lowMm; });
    for (std::size_t i = 1; i < trials.size(); ++i) {
        if (trials[i].lowMm < trials[i - 1].highMm) return true;
    }
    return false;
}

// The parts are volumes, but for leftovers that are small against the largest.
bool areVolumes(const std::vector<Trial>& parts) {
    std::size_t largest = 0;
    std::size_t covered = 0;
    std::size_t total = 0;
    std::size_t leftover = 0;
    for (const Trial& part : parts) {
        total += part.frames;
        if (part.quality != Quality::none) {
            covered += part.frames;
            largest = std::max(largest, part.frames);
        } else {
            leftover = std::max(leftover, part.frames);
        }
    }
    return largest > 0 && 2 * leftover < largest && 5 * covered >= 4 * total;
}

bool isBetter(const Stack& whole, const Partition& partition) {
    const std::vector<Trial> parts = tryOut(whole.frames, partition);
    const auto all = [&](Quality least) {
        return std::all_of(parts.begin(), parts.end(), [&](const Trial& t) { return t.quality >= least; });
    };
    const Quality quality = qualityOf(whole);
    if (quality == Quality::none) return areVolumes(parts);
    // Halves of one volume with a gap between them are even, too, and are one volume all the same.
    if (all(Quality::even)) return interleave(parts);
    // One of two interleaved volumes may lack a slice.
    return quality == Quality::resampled && all(Quality::resampled) &&
           2 * alternations(whole.frames, partition) > whole.frames.size();
}

// Slices of MR that do not overlap are acquired in several passes as a matter of course, the odd ones and the
// even ones, so that none disturbs its neighbour.
bool isAcquiredInterleaved(const Stack& whole) {
    if (whole.modality != "MR" || qualityOf(whole) == Quality::none) return false;
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

// Phase rules in three groups: those that say what they are, those that follow from times, a guess.
enum class PhasesAsked { first, then, last };

PhasesAsked groupOf(const SplitRules::Phase& rule) {
    if (rule.assumed) return PhasesAsked::last;
    return rule.first ? PhasesAsked::first : PhasesAsked::then;
}

class Splitter {
  public:
    Splitter(const std::string& modality, const SplitRules& rules, const CancelToken& cancel)
        : modality_(modality), rules_(rules), cancel_(cancel) {}

    std::vector<Stack> split(std::vector<Frame> frames, std::vector<StackLabel> labels,
                             std::vector<Message>& messages) const {
        Stack whole = makeStack(std::move(frames), std::move(labels), modality_);
        if (whole.frames.size() < 2 || cancel_.cancelled() || isHopeless(whole)) return one(std::move(whole));
        const Message* why = whole.whyNoVolume();
        const bool repeats = why != nullptr && why->key == key::kDuplicatePositions;
        using Asked = PhasesAsked;
        if (repeats) {
            if (auto parts = byPhases(whole, Asked::first, messages)) return std::move(*parts);
        }
        if (auto parts = bySoftAttributes(whole, messages)) return std::move(*parts);
        if (!repeats) {
            if (auto parts = byRuns(whole, messages)) return std::move(*parts);
            if (auto parts = byLattices(whole, messages)) return std::move(*parts);
        }
        if (qualityOf(whole) != Quality::none) return one(std::move(whole));
        if (repeats) {
            if (auto parts = byPhases(whole, Asked::then, messages)) return std::move(*parts);
            for (const Asked asked : {Asked::first, Asked::then, Asked::last}) {
                if (auto parts = bySoftAttributesAndPhases(whole, asked, messages)) return std::move(*parts);
            }
            if (auto parts = byPhases(whole, Asked::last, messages)) return std::move(*parts);
            if (auto parts = byRepetition(whole, messages)) return std::move(*parts);
        }
        if (auto parts = atGaps(whole, messages)) return std::move(*parts);
        return one(std::move(whole));
    }

  private:
    static std::vector<Stack> one(Stack stack) {
        std::vector<Stack> stacks;
        stacks.push_back(std::move(stack));
        return stacks;
    }

    std::vector<Stack> stacksOf(const Stack& whole, const Partition& partition,
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
    std::vector<std::vector<std::size_t>> softCandidates(const Stack& whole) const {
        std::vector<std::size_t> varying;
        for (const SplitRules::Soft& rule : rules_.soft) {
            if (!rule.modality.empty() && rule.modality != modality_) continue;
            if (whole.isEven() && !rule.evenToo) continue;
            if (rule.interleavable && isAcquiredInterleaved(whole)) continue;
            if (partitionByValue(whole.frames, rules_, {rule.attribute}).size() > 1)
                varying.push_back(rule.attribute);
        }
        std::vector<std::vector<std::size_t>> candidates;
        for (const std::size_t attribute : varying) candidates.push_back({attribute});
        for (std::size_t i = 0; i < varying.size(); ++i) {
            for (std::size_t j = i + 1; j < varying.size(); ++j)
                candidates.push_back({varying[i], varying[j]});
        }
        return candidates;
    }

    std::vector<std::string> namesOf(const std::vector<std::size_t>& attributes) const {
        std::vector<std::string> names;
        for (const std::size_t attribute : attributes) names.push_back(rules_.attributes[attribute].name);
        return names;
    }

    static void tellSplit(std::vector<Message>& messages, const std::vector<std::string>& names,
                          std::size_t count) {
        std::string list = names.front();
        for (std::size_t i = 1; i < names.size(); ++i) list += " and " + names[i];
        messages.push_back(
            message(key::kSplitSeries, {{"attributes", list}, {"count", std::int64_t(count)}}));
    }

    std::optional<std::vector<Stack>> bySoftAttributes(const Stack& whole,
                                                       std::vector<Message>& messages) const {
        for (const auto& attributes : softCandidates(whole)) {
            if (!spend(whole.frames.size())) break;
            const Partition partition = partitionByValue(whole.frames, rules_, attributes);
            if (partition.size() > whole.frames.size() / 2) continue;  // single slices are no volumes
            if (!isBetter(whole, partition)) continue;
            const auto names = namesOf(attributes);
            tellSplit(messages, names, partition.size());
            return stacksOf(whole, partition, names);
        }
        return {};
    }

    // Two or more acquisitions at interleaved positions, one after the other.
    std::optional<std::vector<Stack>> byRuns(const Stack& whole, std::vector<Message>& messages) const {
        constexpr std::size_t kMostRuns = 4;
        if (whole.modality == "MR") return {};  // whose odd and even slices are often acquired in turn
        for (const std::size_t attribute : rules_.runs) {
            for (std::size_t count = 2; count <= kMostRuns; ++count) {
                const Partition partition = partitionByRuns(whole.frames, attribute, count);
                if (partition.empty() || partition.size() > whole.frames.size() / 2) break;
                if (!spend(whole.frames.size())) return {};
                if (2 * alternations(whole.frames, partition) <= whole.frames.size()) continue;
                if (!isBetter(whole, partition)) continue;
                tellSplit(messages, namesOf({attribute}), partition.size());
                return stacksOf(whole, partition, namesOf({attribute}));
            }
        }
        return {};
    }

    // Two acquisitions of which nothing but their positions tells: these alternate between two distances.
    std::optional<std::vector<Stack>> byLattices(const Stack& whole, std::vector<Message>& messages) const {
        if (whole.isEven()) return {};
        const Partition partition = separateLattices(whole.frames);
        if (partition.empty() || !isBetter(whole, partition)) return {};
        // A volume that lacks slices is no two, unless it lacked every third throughout.
        const std::size_t count = alternations(whole.frames, partition);
        const bool hasGaps = std::any_of(whole.messages.begin(), whole.messages.end(),
                                         [](const Message& m) { return m.key == key::kMissingSlices; });
        if (hasGaps ? count + 1 < whole.frames.size() : 2 * count <= whole.frames.size()) return {};
        std::vector<Stack> stacks = stacksOf(whole, partition, {"Positions"});
        const double offsetMm = glm::length(*stacks[1].firstPositionMm - *stacks[0].firstPositionMm);
        messages.push_back(message(key::kInterleavedPositions, {{"offsetMm", offsetMm}}));
        return stacks;
    }

    Partition phasesOf(const std::vector<Frame>& frames, const SplitRules::Phase& rule) const {
        return rule.by == SplitRules::Phase::By::rank
                   ? partitionByRank(frames, rules_, rule.attribute, !rule.assumed)
                   : partitionByValue(frames, rules_, {rule.attribute});
    }

    static void nameStackPhases(std::vector<Stack>& stacks, std::size_t begin, bool assumed) {
        for (std::size_t i = begin; i < stacks.size(); ++i) {
            stacks[i].phase = static_cast<int>(i - begin);
            stacks[i].phases = static_cast<int>(stacks.size() - begin);
            if (assumed) {
                stacks[i].assumptions.emplace_back(
                    "Images at one position were told apart by the order of their numbers.");
            }
        }
    }

    std::optional<std::vector<Stack>> byPhases(const Stack& whole, PhasesAsked asked,
                                               std::vector<Message>& messages) const {
        for (const SplitRules::Phase& rule : rules_.phases) {
            if (groupOf(rule) != asked || cancel_.cancelled()) continue;
            const Partition partition = phasesOf(whole.frames, rule);
            if (partition.size() < 2 || partition.size() > whole.frames.size() / 2) continue;
            if (!areVolumes(tryOut(whole.frames, partition))) continue;
            const std::string& name = rules_.attributes[rule.attribute].name;
            std::vector<Stack> phases = stacksOf(whole, partition, {name});
            nameStackPhases(phases, 0, rule.assumed);
            tellPhases(messages, rule, phases.size());
            tellIncomplete(phases, messages);
            return phases;
        }
        return {};
    }

    static void tellIncomplete(const std::vector<Stack>& phases, std::vector<Message>& messages) {
        std::size_t most = 0;
        for (const Stack& phase : phases) most = std::max(most, phase.frames.size());
        const auto fewer = std::count_if(phases.begin(), phases.end(),
                                         [&](const Stack& phase) { return phase.frames.size() < most; });
        if (fewer == 0) return;
        messages.push_back(message(key::kIncompletePhases,
                                   {{"count", std::int64_t(fewer)}, {"total", std::int64_t(phases.size())}}));
    }

    void tellPhases(std::vector<Message>& messages, const SplitRules::Phase& rule, std::size_t count) const {
        messages.push_back(
            message(rule.assumed ? key::kPhasesAssumed : key::kPhases,
                    {{"count", std::int64_t(count)}, {"attribute", rules_.attributes[rule.attribute].name}}));
    }

    // Several phases in each of several reconstructions.
    std::optional<std::vector<Stack>> bySoftAttributesAndPhases(const Stack& whole, PhasesAsked asked,
                                                                std::vector<Message>& messages) const {
        for (const auto& attributes : softCandidates(whole)) {
            const Partition coarse = partitionByValue(whole.frames, rules_, attributes);
            if (coarse.size() > whole.frames.size() / 4) continue;
            for (const SplitRules::Phase& rule : rules_.phases) {
                if (groupOf(rule) != asked) continue;
                if (!spend(whole.frames.size())) return {};
                Partition all;
                std::vector<std::size_t> counts;
                for (const Part& part : coarse) {
                    std::vector<Frame> frames;
                    for (const std::size_t index : part.frames) frames.push_back(whole.frames[index]);
                    const Partition finer = within(part, phasesOf(frames, rule));
                    counts.push_back(finer.size());
                    all.insert(all.end(), finer.begin(), finer.end());
                }
                const bool isPartition =
                    std::none_of(counts.begin(), counts.end(), [](std::size_t c) { return c == 0; });
                if (!isPartition || all.size() > whole.frames.size() / 2) continue;
                if (!areVolumes(tryOut(whole.frames, all))) continue;
                auto names = namesOf(attributes);
                tellSplit(messages, names, coarse.size());
                tellPhases(messages, rule, *std::max_element(counts.begin(), counts.end()));
                names.push_back(rules_.attributes[rule.attribute].name);
                std::vector<Stack> stacks;
                std::size_t begin = 0;
                for (const std::size_t count : counts) {
                    const Partition phases(all.begin() + static_cast<std::ptrdiff_t>(begin),
                                           all.begin() + static_cast<std::ptrdiff_t>(begin + count));
                    std::vector<Stack> made = stacksOf(whole, phases, names);
                    nameStackPhases(made, 0, rule.assumed);
                    for (Stack& stack : made) stacks.push_back(std::move(stack));
                    begin += count;
                }
                tellIncomplete(stacks, messages);
                return stacks;
            }
        }
        return {};
    }

    std::optional<std::vector<Stack>> byRepetition(const Stack& whole, std::vector<Message>& messages) const {
        const Partition partition = separateRepetitions(whole.frames);
        if (partition.size() != 2) return {};
        // Many repetitions are no slip, and which of them belong together is for a person to say.
        if (5 * partition[1].frames.size() > partition[0].frames.size()) return {};
        std::vector<Stack> stacks = stacksOf(whole, partition, {"Repetition"});
        if (qualityOf(stacks[0]) == Quality::none) return {};
        const Message told =
            message(key::kRepeatedSlices, {{"count", std::int64_t(partition[1].frames.size())}});
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
    std::optional<std::vector<Stack>> atGaps(const Stack& whole, std::vector<Message>& messages) const {
        const std::string& why = whole.whyNoVolume()->key;
        if (why != key::kMissingSlices && why != key::kSpacingTooIrregular) return {};
        const Partition partition = separateAtGaps(whole.frames);
        if (partition.size() < 2) return {};
        if (!areVolumes(tryOut(whole.frames, partition))) return {};
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
    bool spend(std::size_t frames) const {
        constexpr std::size_t kMostFramesTried = 1'000'000;
        tried_ += frames;
        return tried_ <= kMostFramesTried && !cancel_.cancelled();
    }

    const std::string& modality_;
    const SplitRules& rules_;
    const CancelToken& cancel_;
    mutable std::size_t tried_ = 0;
};

// A total order that depends on the images only, so that neither file names nor the file system matter.
void sortFrames(std::vector<Frame>& frames) {
    std::stable_sort(frames.begin(), frames.end(), [](const Frame& a, const Frame& b) {
        const auto key = [](const Frame& f) {
            return std::tuple(f.instance->instanceNumber.value_or(0),
                              std::string_view(f.instance->sopInstanceUid), f.number);
        };
        return key(a) < key(b);
    });
}

// Frames that have their identifier and number in common with another one of the part.
std::size_t countOfSharedUids(const Part& part, const std::vector<Frame>& frames) {
    std::map<std::pair<std::string_view, int>, std::size_t> counts;
    for (const std::size_t index : part.frames) {
        const std::string& uid = frames[index].instance->sopInstanceUid;
        if (!uid.empty()) ++counts[{uid, frames[index].number}];
    }
    std::size_t sharing = 0;
    for (const auto& [frame, count] : counts) sharing += count > 1 ? count : 0;
    return sharing;
}

std::string modalityOf(const std::vector<Frame>& frames, const std::string& ofSeries) {
    const std::string& own = frames.front().instance->modality;
    return own.empty() ? ofSeries : own;
}

// Files that share an identifier and a position, and differ: the first of each stays.
std::vector<Stack> takeCopies(std::vector<Frame>& frames, const std::string& modality,
                              std::vector<Message>& messages) {
    const Partition partition = separateCopies(frames);
    std::vector<Stack> stacks;
    if (const std::size_t sharing = countOfSharedUids(partition.front(), frames); sharing > 0)
        messages.push_back(message(key::kSharedInstanceUid, {{"count", std::int64_t(sharing)}}));
    if (partition.size() < 2) return stacks;
    for (std::size_t copy = 1; copy < partition.size(); ++copy) {
        std::vector<Frame> taken;
        for (const std::size_t index : partition[copy].frames) taken.push_back(frames[index]);
        const std::string own = modalityOf(taken, modality);
        stacks.push_back(makeStack(std::move(taken), {{"Copy", partition[copy].values.front()}}, own));
    }
    messages.push_back(message(key::kDuplicateInstances,
                               {{"count", std::int64_t(frames.size() - partition.front().frames.size())}}));
    std::vector<Frame> kept;
    for (const std::size_t index : partition.front().frames) kept.push_back(std::move(frames[index]));
    frames = std::move(kept);
    return stacks;
}

}  // namespace

Split splitSeries(std::vector<Frame> frames, const std::string& modality, const SplitRules& rules,
                  const CancelToken& cancel) {
    Split split;
    if (frames.empty()) return split;
    sortFrames(frames);
    std::vector<Stack> copies = takeCopies(frames, modality, split.messages);
    const std::optional<Message> unplaced = imagesWithoutPosition(frames);
    const TryStacks tryStacks = [&](std::vector<Frame> tried) {
        std::vector<Message> unused;
        const std::string ofTried = modalityOf(tried, modality);
        return Splitter(ofTried, rules, cancel).split(std::move(tried), {}, unused);
    };
    std::vector<Stack> leftOut;
    for (HardPart& part : splitHard(std::move(frames), rules, tryStacks, split.messages)) {
        const std::string ofPart = modalityOf(part.frames, modality);
        if (unplaced && part.frames.front().positionMm) part.told.push_back(*unplaced);
        for (OddImages& odd : takeOddImages(part.frames, ofPart)) {
            std::vector<StackLabel> labels = part.labels;
            labels.push_back(odd.label);
            leftOut.push_back(makeStack(std::move(odd.frames), std::move(labels), ofPart));
            part.told.push_back(std::move(odd.message));
        }
        for (Stack& stack : Splitter(ofPart, rules, cancel)
                                .split(std::move(part.frames), std::move(part.labels), split.messages)) {
            for (const Message& told : part.told) {
                stack.messages.push_back(told);
                stack.assumptions.push_back(told.sentence);
            }
            split.stacks.push_back(std::move(stack));
        }
    }
    for (Stack& stack : leftOut) split.stacks.push_back(std::move(stack));
    for (Stack& stack : copies) split.stacks.push_back(std::move(stack));
    for (Stack& stack : split.stacks) tellChanges(stack, rules);
    return split;
}

}  // namespace macula::dicom
