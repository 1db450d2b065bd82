#include "dicom/split/trial.h"

#include <algorithm>

namespace macula::dicom {

namespace {

bool says(const std::vector<Message>& messages, std::string_view key) {
    return std::ranges::any_of(messages, [&](const Message& message) { return message.key == key; });
}

bool areAtLeast(std::span<const Trial> parts, Grade least) {
    return std::ranges::all_of(parts, [&](const Trial& part) { return part.grade >= least; });
}

}  // namespace

Grade gradeOf(const Stack& stack) {
    if (!stack.canBeVolume()) return Grade::none;
    if (stack.isEven()) return Grade::even;
    return says(stack.messages, key::kIrregularSpacing) ? Grade::irregular : Grade::gapped;
}

std::vector<Trial> tryOut(std::span<const Frame> frames, const Partition& partition) {
    const glm::dvec3 normal = frames.front().plane->normal();
    std::vector<Trial> trials;
    for (const Part& part : partition) {
        std::vector<StackedPlane> planes;
        for (const std::size_t index : part.frames) planes.push_back({*frames[index].plane});
        const StackGeometry geometry = stackPlanes(planes);
        const auto along = [&](std::size_t place) {
            return glm::dot(planes[geometry.order[place]].plane.positionMm, normal);
        };
        Grade grade = Grade::none;
        if (geometry.quality == StackGeometry::Quality::even) grade = Grade::even;
        if (geometry.quality == StackGeometry::Quality::resampled)
            grade = says(geometry.messages, key::kIrregularSpacing) ? Grade::irregular : Grade::gapped;
        trials.push_back({grade, planes.size(), along(0), along(planes.size() - 1)});
    }
    return trials;
}

bool interleave(std::vector<Trial> parts) {
    std::ranges::sort(parts, {}, &Trial::lowMm);
    double highMm = parts.front().highMm;
    for (std::size_t n = 1; n < parts.size(); ++n) {
        if (parts[n].lowMm < highMm) return true;
        highMm = std::max(highMm, parts[n].highMm);
    }
    return false;
}

bool areVolumes(std::span<const Trial> parts, Grade least) {
    std::size_t largest = 0;
    std::size_t covered = 0;
    std::size_t total = 0;
    std::size_t leftover = 0;
    for (const Trial& part : parts) {
        total += part.frames;
        if (part.grade >= least) {
            covered += part.frames;
            largest = std::max(largest, part.frames);
        } else {
            leftover = std::max(leftover, part.frames);
        }
    }
    return largest > 0 && 2 * leftover < largest && 5 * covered >= 4 * total;
}

bool arePhases(std::span<const Trial> parts, std::size_t positions) {
    const auto count = std::ranges::count_if(parts, [&](const Trial& part) {
        return part.grade != Grade::none && 4 * part.frames >= 3 * positions;
    });
    return count >= 2 && 2 * count >= std::ssize(parts);
}

bool isBetter(const Stack& whole, const Partition& partition, Grade least) {
    const std::vector<Trial> parts = tryOut(whole.frames, partition);
    const auto alternate = [&] { return 2 * alternations(whole.frames, partition) > whole.frames.size(); };
    switch (gradeOf(whole)) {
        case Grade::none:
            return areVolumes(parts, least);
        case Grade::irregular:
            if (least > Grade::irregular) return areVolumes(parts, least) && interleave(parts);
            return areAtLeast(parts, least) && alternate();
        case Grade::gapped:
            // Halves of one volume with a gap between them are even, too, and are one volume all the same.
            // One of two interleaved volumes may lack a slice.
            if (areAtLeast(parts, Grade::even)) return interleave(parts);
            return areAtLeast(parts, Grade::gapped) && alternate();
        case Grade::even:
            return areAtLeast(parts, Grade::even) && interleave(parts);
    }
    return false;
}

}  // namespace macula::dicom
