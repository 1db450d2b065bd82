#include "dicom/split/hard_split.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string_view>

#include "dicom/split/partition.h"

namespace macula::dicom {

namespace {

// What to say when images that name different coordinate systems, or none, look as if they shared one: either
// no two name the same, as a program leaves them that makes every identifier anew, or some name none.
std::optional<Message> likelyOneFrameOfReference(const std::vector<Frame>& frames,
                                                 const Partition& partition) {
    std::set<std::string_view> names;
    std::size_t silent = 0;
    for (const Frame& frame : frames) {
        if (frame.frameOfReferenceUid.empty()) {
            ++silent;
        } else {
            names.insert(frame.frameOfReferenceUid);
        }
    }
    if (2 * silent > frames.size()) return {};
    constexpr std::size_t kLeastImages = 3;
    if (names.size() >= kLeastImages && names.size() + silent == frames.size())
        return message(key::kFrameOfReferencePerSlice);
    // Two sets of frames that alternate are not one coordinate system.
    if (names.size() == 1 && 2 * alternations(frames, partition) <= frames.size()) {
        return message(key::kFrameOfReferenceMissing,
                       {{"count", std::int64_t(silent)}, {"total", std::int64_t(frames.size())}});
    }
    return {};
}

// Gives the frames of the part no coordinate system when they are likely to share one, and every one of them
// is in an even volume then, with gaps perhaps.
bool assumeOneFrameOfReference(HardPart& part, const Partition& partition, std::size_t attribute,
                               const TryStacks& tryStacks) {
    auto told = likelyOneFrameOfReference(part.frames, partition);
    if (!told) return false;
    std::vector<Frame> frames = part.frames;
    for (Frame& frame : frames) {
        frame.frameOfReferenceUid.clear();
        frame.attributes[attribute].clear();
    }
    for (const Stack& stack : tryStacks(frames)) {
        const bool irregular = std::any_of(stack.messages.begin(), stack.messages.end(),
                                           [](const auto& m) { return m.key == key::kIrregularSpacing; });
        if (!stack.canBeVolume() || irregular) return false;
    }
    part.frames = std::move(frames);
    part.told.push_back(std::move(*told));
    return true;
}

// Whether `part` is a few images of the largest part that lie otherwise, or whose place is unknown. Without
// them the volume is not complete.
bool isLeftOver(const HardPart& part, const HardPart& largest) {
    static const std::set<std::string> kPlacement = {
        "FrameOfReferenceUID", "ImagePlane", "Rows", "Columns", "ImageOrientationPatient", "PixelSpacing"};
    constexpr std::size_t kFew = 5;  // times
    if (kFew * part.frames.size() > largest.frames.size()) return false;
    return std::all_of(part.labels.begin(), part.labels.end(), [&](const StackLabel& label) {
        if (kPlacement.contains(label.attribute)) return true;
        return std::find(largest.labels.begin(), largest.labels.end(), label) != largest.labels.end();
    });
}

// Frames that are alone in their part although they agree in all but how they lie (a rotation of projections,
// a localizer in three planes) are put together again.
void joinLoners(std::vector<HardPart>& parts) {
    static const std::set<std::string> kPlacement = {"ImageOrientationPatient", "PixelSpacing"};
    std::map<std::string, std::size_t> homes;  // by all other labels
    std::vector<HardPart> result;
    for (HardPart& part : parts) {
        if (part.frames.size() != 1) {
            result.push_back(std::move(part));
            continue;
        }
        std::string home;
        std::vector<StackLabel> labels;
        for (const StackLabel& label : part.labels) {
            if (kPlacement.contains(label.attribute)) continue;
            home += label.attribute + '=' + label.value + '\n';
            labels.push_back(label);
        }
        const auto [place, isNew] = homes.emplace(home, result.size());
        if (isNew) {
            result.push_back(std::move(part));
        } else {
            HardPart& together = result[place->second];
            together.labels = labels;
            together.frames.push_back(std::move(part.frames.front()));
        }
    }
    parts = std::move(result);
}

}  // namespace

std::vector<HardPart> splitHard(std::vector<Frame> frames, const SplitRules& rules,
                                const TryStacks& tryStacks, std::vector<Message>& messages) {
    std::vector<HardPart> parts;
    std::vector<std::pair<std::string, std::string>> told;  // key, attribute
    const auto placed = std::stable_partition(frames.begin(), frames.end(),
                                              [](const Frame& f) { return f.plane.has_value(); });
    const bool somePlaced = placed != frames.begin() && placed != frames.end();
    if (somePlaced) {
        told.emplace_back(key::kInconsistentPosition, "ImagePlane");
        parts.push_back({{std::make_move_iterator(placed), std::make_move_iterator(frames.end())},
                         {{"ImagePlane", "missing"}},
                         {}});
        frames.erase(placed, frames.end());
    }
    std::vector<StackLabel> labels;
    if (somePlaced) labels.push_back({"ImagePlane", "given"});
    parts.insert(parts.begin(), {std::move(frames), std::move(labels), {}});
    for (const SplitRules::Hard& rule : rules.hard) {
        std::vector<HardPart> finer;
        for (HardPart& part : parts) {
            const Partition partition = partitionByValue(part.frames, rules, {rule.attribute});
            if (partition.size() < 2) {
                finer.push_back(std::move(part));
                continue;
            }
            const std::string& name = rules.attributes[rule.attribute].name;
            if (name == "FrameOfReferenceUID" && part.frames.front().plane) {
                if (assumeOneFrameOfReference(part, partition, rule.attribute, tryStacks)) {
                    finer.push_back(std::move(part));
                    continue;
                }
            }
            if (told.empty() || told.back().second != name) told.emplace_back(rule.message, name);
            for (const Part& piece : partition) {
                HardPart next{{}, part.labels, {}};
                next.labels.push_back({name, piece.values.front()});
                for (const std::size_t index : piece.frames) next.frames.push_back(part.frames[index]);
                finer.push_back(std::move(next));
            }
        }
        parts = std::move(finer);
    }
    joinLoners(parts);
    if (parts.size() > 1) {
        const HardPart& largest = *std::max_element(
            parts.begin(), parts.end(),
            [](const HardPart& a, const HardPart& b) { return a.frames.size() < b.frames.size(); });
        const bool anyLeftOver = std::any_of(parts.begin(), parts.end(),
                                             [&](const HardPart& p) { return isLeftOver(p, largest); });
        for (const auto& [key, attribute] : told) {
            messages.push_back(
                message(key, {{"attributes", attribute}, {"count", std::int64_t(parts.size())}}));
            if (anyLeftOver) messages.back().severity = Severity::warning;
        }
    }
    return parts;
}

}  // namespace macula::dicom
