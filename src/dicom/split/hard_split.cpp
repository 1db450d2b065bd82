#include "dicom/split/hard_split.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string_view>

#include "dicom/split/partition.h"
#include "dicom/split/trial.h"

namespace macula::dicom {

namespace {

// The message on images that name different coordinate systems, or none, but probably share one: either no
// two name the same, because a program replaced every identifier, or some name none.
std::optional<Message> likelyOneFrameOfReference(const std::vector<Frame>& frames) {
    std::set<std::string_view> names;
    std::size_t silent = 0;
    for (const Frame& frame : frames) {
        if (frame.frameOfReferenceUid.empty()) {
            ++silent;
        } else {
            names.insert(frame.frameOfReferenceUid);
        }
    }
    if (2 * silent > frames.size() + 1) return {};
    constexpr std::size_t kLeastImages = 3;
    if (names.size() >= kLeastImages && names.size() + silent == frames.size())
        return message(key::kFrameOfReferencePerSlice);
    if (names.size() == 1) {
        return message(key::kFrameOfReferenceMissing,
                       {{"count", std::int64_t(silent)}, {"total", std::int64_t(frames.size())}});
    }
    return {};
}

// Removes the coordinate systems of the part's frames if they probably share one, and every frame is then in
// an even volume, possibly with gaps.
bool assumeOneFrameOfReference(HardPart& part, std::size_t attribute, const TryStacks& tryStacks) {
    auto told = likelyOneFrameOfReference(part.frames);
    if (!told) return false;
    std::vector<Frame> frames = part.frames;
    for (Frame& frame : frames) {
        frame.frameOfReferenceUid.clear();
        frame.attributes[attribute].clear();
    }
    for (const Stack& stack : tryStacks(frames)) {
        const bool irregular = std::any_of(stack.messages.begin(), stack.messages.end(),
                                           [](const auto& m) { return m.key == key::kIrregularSpacing; });
        const bool isOfLattice = !stack.splitBy.empty() && stack.splitBy.back().attribute == "Positions";
        if (!stack.canBeVolume() || irregular || isOfLattice) return false;
    }
    part.frames = std::move(frames);
    part.told.push_back(std::move(*told));
    return true;
}

// Treats frames of several stacks (StackID) that lie end to end as one stack if they make one even volume.
bool assumeOneStack(HardPart& part, const Partition& partition, std::size_t attribute,
                    const TryStacks& tryStacks) {
    if (interleave(tryOut(part.frames, partition))) return false;
    std::vector<Frame> frames = part.frames;
    for (Frame& frame : frames) frame.attributes[attribute].clear();
    const std::vector<Stack> stacks = tryStacks(frames);
    if (stacks.size() != 1 || !stacks.front().isEven()) return false;
    part.frames = std::move(frames);
    part.told.push_back(message(key::kStacksJoined, {{"count", std::int64_t(partition.size())}}));
    return true;
}

// Replaces orientations that differ by less than anybody could see by their mean: some writers compute the
// directions of each slice separately. A corner of a slice may move by a tenth of a voxel, or, with a
// warning, by half of one.
bool assumeOneOrientation(HardPart& part, std::size_t attribute) {
    constexpr double kTellOfVoxel = 0.1;
    constexpr double kMostOfVoxel = 0.5;
    glm::dvec3 row{0.0};
    glm::dvec3 column{0.0};
    for (const Frame& frame : part.frames) {
        if (!frame.plane || !isUsable(*frame.plane)) return false;
        row += frame.plane->rowDirection;
        column += frame.plane->columnDirection;
    }
    if (!(glm::length(row) > 0.0 && glm::length(column) > 0.0)) return false;
    row = glm::normalize(row);
    column = glm::normalize(column - glm::dot(column, row) * row);
    double errorMm = 0.0;
    double radians = 0.0;
    double voxelMm = std::numeric_limits<double>::infinity();
    for (const Frame& frame : part.frames) {
        const ImagePlane& plane = *frame.plane;
        const glm::dvec3 alongRow =
            (plane.rowDirection - row) * (plane.columnSpacingMm * double(frame.instance->columns - 1));
        const glm::dvec3 alongColumn =
            (plane.columnDirection - column) * (plane.rowSpacingMm * double(frame.instance->rows - 1));
        errorMm = std::max(
            {errorMm, glm::length(alongRow), glm::length(alongColumn), glm::length(alongRow + alongColumn)});
        radians = std::max(
            {radians, glm::length(plane.rowDirection - row), glm::length(plane.columnDirection - column)});
        voxelMm = std::min({voxelMm, plane.columnSpacingMm, plane.rowSpacingMm});
    }
    if (errorMm > kMostOfVoxel * voxelMm) return false;
    for (Frame& frame : part.frames) {
        frame.plane->rowDirection = row;
        frame.plane->columnDirection = column;
        frame.attributes[attribute] = part.frames.front().attributes[attribute];
    }
    Message told =
        message(key::kOrientationDrift, {{"degrees", glm::degrees(radians)}, {"errorMm", errorMm}});
    if (errorMm > kTellOfVoxel * voxelMm) told.severity = Severity::warning;
    part.told.push_back(std::move(told));
    return true;
}

// Whether `part` is a few images of the largest part that are placed differently, or at an unknown place.
// Without them the volume is incomplete.
bool isLeftOver(const HardPart& part, const HardPart& largest) {
    static const std::set<std::string> kPlacement = {
        "FrameOfReferenceUID", "ImagePlane", "Rows", "Columns", "ImageOrientationPatient", "PixelSpacing"};
    constexpr std::size_t kFew = 5;  // the largest part is at least this many times larger
    if (kFew * part.frames.size() > largest.frames.size()) return false;
    return std::all_of(part.labels.begin(), part.labels.end(), [&](const StackLabel& label) {
        if (kPlacement.contains(label.attribute)) return true;
        return std::find(largest.labels.begin(), largest.labels.end(), label) != largest.labels.end();
    });
}

// Whether frames that differ in a hard attribute count as one stack all the same; a message then states the
// assumption.
bool areOneAfterAll(const std::string& name, HardPart& part, const Partition& partition,
                    std::size_t attribute, const TryStacks& tryStacks) {
    if (name == "FrameOfReferenceUID") return assumeOneFrameOfReference(part, attribute, tryStacks);
    if (name == "StackID") return assumeOneStack(part, partition, attribute, tryStacks);
    if (name == "ImageOrientationPatient") return assumeOneOrientation(part, attribute);
    return false;
}

// Rejoins frames that are alone in their part although they agree in everything but orientation and spacing
// (a rotation of projections, a localizer in three planes).
void joinLoners(std::vector<HardPart>& parts) {
    static const std::set<std::string> kPlacement = {"ImageOrientationPatient", "PixelSpacing"};
    std::map<std::string, std::size_t> homes;  // index in `result`, by all other labels
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
            if (part.frames.front().plane &&
                areOneAfterAll(name, part, partition, rule.attribute, tryStacks)) {
                finer.push_back(std::move(part));
                continue;
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
