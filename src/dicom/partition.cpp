#include "dicom/partition.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

namespace macula::dicom {

namespace {

bool before(std::string_view a, std::string_view b) {
    const auto x = numberOf(a);
    const auto y = numberOf(b);
    if (x && y && *x != *y) return *x < *y;
    if (x.has_value() != y.has_value()) return x.has_value();
    return a < b;
}

// Values of one attribute to the number of their class; classes by ascending value.
std::map<std::string, std::size_t, std::less<>> classesOf(const Attribute& attribute,
                                                          std::vector<std::string_view> values) {
    std::sort(values.begin(), values.end(), before);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    std::map<std::string, std::size_t, std::less<>> classes;
    std::vector<std::string_view> first;  // of each class
    // A single number is near the class just before it, if any. Vectors have no such order; of them there
    // are never many different ones that are all the same.
    const bool ordered = attribute.kind == Attribute::Kind::number;
    constexpr std::ptrdiff_t kMostCompared = 1000;
    for (const std::string_view value : values) {
        const auto known = static_cast<std::ptrdiff_t>(first.size());
        const auto begin = first.end() - std::min(known, ordered ? 1 : kMostCompared);
        const auto found = attribute.kind == Attribute::Kind::text
                               ? first.end()
                               : std::find_if(begin, first.end(), [&](std::string_view other) {
                                     return sameValue(attribute, other, value);
                                 });
        classes.emplace(value, static_cast<std::size_t>(found - first.begin()));
        if (found == first.end()) first.push_back(value);
    }
    return classes;
}

// Indices of frames that have a plane, ascending along the normal of the first, in groups at one position.
std::vector<std::vector<std::size_t>> positionsOf(std::span<const Frame> frames,
                                                  std::vector<double>& alongMm) {
    std::vector<std::pair<double, std::size_t>> sorted;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        if (!frames[i].plane) return {};
        sorted.emplace_back(glm::dot(frames[i].plane->positionMm, frames[0].plane->normal()), i);
    }
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::vector<std::size_t>> groups;
    for (const auto& [along, index] : sorted) {
        // Against the group's first, so that a group cannot grow along a chain of small distances.
        if (groups.empty() || !(along - alongMm.back() <= kSamePositionMm)) {
            groups.emplace_back();
            alongMm.push_back(along);
        }
        groups.back().push_back(index);
    }
    return groups;
}

}  // namespace

Partition partitionByValue(std::span<const Frame> frames, const SplitRules& rules,
                           const std::vector<std::size_t>& attributes) {
    std::vector<std::map<std::string, std::size_t, std::less<>>> classes;
    for (const std::size_t attribute : attributes) {
        std::vector<std::string_view> values;
        for (const Frame& frame : frames) values.push_back(frame.attributes[attribute]);
        classes.push_back(classesOf(rules.attributes[attribute], std::move(values)));
    }
    std::map<std::vector<std::size_t>, Part> parts;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        std::vector<std::size_t> key;
        for (std::size_t a = 0; a < attributes.size(); ++a) {
            key.push_back(classes[a].find(frames[i].attributes[attributes[a]])->second);
        }
        Part& part = parts[key];
        if (part.frames.empty()) {
            for (const std::size_t attribute : attributes)
                part.values.push_back(frames[i].attributes[attribute]);
        }
        part.frames.push_back(i);
    }
    Partition partition;
    for (auto& [key, part] : parts) partition.push_back(std::move(part));
    return partition;
}

Partition partitionByRank(std::span<const Frame> frames, const SplitRules& rules, std::size_t attribute) {
    std::vector<double> alongMm;
    auto positions = positionsOf(frames, alongMm);
    if (positions.empty()) return {};
    const auto& valueOf = [&](std::size_t index) -> const std::string& {
        return frames[index].attributes[attribute];
    };
    Partition partition(positions.front().size());
    for (auto& group : positions) {
        if (group.size() != partition.size()) return {};
        std::stable_sort(group.begin(), group.end(),
                         [&](std::size_t a, std::size_t b) { return before(valueOf(a), valueOf(b)); });
        for (std::size_t rank = 0; rank < group.size(); ++rank) {
            if (valueOf(group[rank]).empty()) return {};
            if (rank > 0 &&
                sameValue(rules.attributes[attribute], valueOf(group[rank - 1]), valueOf(group[rank]))) {
                return {};
            }
            partition[rank].frames.push_back(group[rank]);
        }
    }
    for (Part& part : partition) {
        part.values = {valueOf(part.frames.front())};
        std::sort(part.frames.begin(), part.frames.end());
    }
    return partition;
}

Partition separateCopies(std::span<const Frame> frames) {
    Partition partition;
    std::map<std::pair<std::string_view, int>, std::size_t> seen;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const std::string& uid = frames[i].instance->sopInstanceUid;
        const std::size_t copy = uid.empty() ? 0 : seen[{uid, frames[i].number}]++;
        while (partition.size() <= copy) partition.push_back({{std::to_string(partition.size() + 1)}, {}});
        partition[copy].frames.push_back(i);
    }
    return partition;
}

Partition separateRepetitions(std::span<const Frame> frames) {
    std::vector<double> alongMm;
    Partition partition(2);
    partition[0].values = {"first"};
    partition[1].values = {"others"};
    for (const auto& group : positionsOf(frames, alongMm)) {
        const std::size_t first =
            *std::min_element(group.begin(), group.end(), [&](std::size_t a, std::size_t b) {
                const auto key = [&](std::size_t i) {
                    const Instance& instance = *frames[i].instance;
                    return std::tuple(instance.instanceNumber.value_or(0),
                                      std::string_view(instance.sopInstanceUid), frames[i].number);
                };
                return key(a) < key(b);
            });
        for (const std::size_t index : group) partition[index == first ? 0 : 1].frames.push_back(index);
    }
    std::erase_if(partition, [](const Part& part) { return part.frames.empty(); });
    return partition;
}

Partition separateAtGaps(std::span<const Frame> frames) {
    constexpr double kWideGapOfStep = 8.0;
    std::vector<double> alongMm;
    const auto positions = positionsOf(frames, alongMm);
    Partition partition;
    if (positions.size() < 3) return partition;
    std::vector<double> steps;
    for (std::size_t k = 1; k < alongMm.size(); ++k) steps.push_back(alongMm[k] - alongMm[k - 1]);
    std::vector<double> sorted = steps;
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2),
                     sorted.end());
    const double usual = sorted[sorted.size() / 2];
    for (std::size_t k = 0; k < positions.size(); ++k) {
        if (k == 0 || steps[k - 1] > kWideGapOfStep * usual) {
            partition.push_back({{std::to_string(partition.size() + 1)}, {}});
        }
        partition.back().frames.insert(partition.back().frames.end(), positions[k].begin(),
                                       positions[k].end());
    }
    for (Part& part : partition) std::sort(part.frames.begin(), part.frames.end());
    return partition;
}

}  // namespace macula::dicom
