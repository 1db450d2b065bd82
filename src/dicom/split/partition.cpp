#include "dicom/split/partition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "dicom/split/frame_order.h"

namespace macula::dicom {

namespace {

// Orders numbers before words; of several numbers the first that differs counts: 1\\2 is before 1\\10.
bool before(std::string_view a, std::string_view b) {
    std::string_view restOfA = a;
    std::string_view restOfB = b;
    while (true) {
        const auto x = numberOf(restOfA);
        const auto y = numberOf(restOfB);
        if (x.has_value() != y.has_value()) return x.has_value();
        if (!x) return a < b;
        if (*x != *y) return *x < *y;
        const std::size_t endOfA = restOfA.find('\\');
        const std::size_t endOfB = restOfB.find('\\');
        if (endOfA == std::string_view::npos || endOfB == std::string_view::npos)
            return endOfA == endOfB ? a < b : endOfA == std::string_view::npos;
        restOfA.remove_prefix(endOfA + 1);
        restOfB.remove_prefix(endOfB + 1);
    }
}

// Maps values of one attribute to the number of their class; classes are by ascending value.
std::map<std::string, std::size_t, std::less<>> classesOf(const Attribute& attribute,
                                                          std::vector<std::string_view> values) {
    // Most values are equal: removes these as text, which is cheaper than parsing their numbers.
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    std::sort(values.begin(), values.end(), before);
    std::map<std::string, std::size_t, std::less<>> classes;
    std::vector<std::string_view> first;  // the first value of each class
    // A single number is near the class just before it, if any. Vectors have no such order, and are compared
    // with many classes.
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

// The number of each frame's class.
std::vector<std::size_t> classesOfTexts(std::span<const Frame> frames, const SplitRules& rules,
                                        std::size_t attribute) {
    std::vector<std::string_view> values;
    for (const Frame& frame : frames) values.push_back(frame.attributes[attribute]);
    const auto classes = classesOf(rules.attributes[attribute], std::move(values));
    std::vector<std::size_t> result;
    for (const Frame& frame : frames) result.push_back(classes.find(frame.attributes[attribute])->second);
    return result;
}

std::vector<std::size_t> classesOfTimes(const std::vector<std::optional<double>>& times) {
    std::vector<std::optional<double>> distinct = times;  // frames without a time come first
    std::ranges::sort(distinct);
    std::vector<std::size_t> result;
    distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
    for (const auto& time : times) {
        const auto place = std::ranges::lower_bound(distinct, time);
        result.push_back(static_cast<std::size_t>(place - distinct.begin()));
    }
    return result;
}

}  // namespace

Partition partitionByValue(std::span<const Frame> frames, const SplitRules& rules,
                           const std::vector<std::size_t>& attributes) {
    std::vector<std::vector<std::size_t>> classes;
    for (const std::size_t attribute : attributes)
        classes.push_back(rules.attributes[attribute].kind == Attribute::Kind::time
                              ? classesOfTimes(orderValues(frames, rules, attribute))
                              : classesOfTexts(frames, rules, attribute));
    std::map<std::vector<std::size_t>, Part> parts;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        std::vector<std::size_t> key;
        for (const auto& of : classes) key.push_back(of[i]);
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

Partition within(const Part& coarse, const Partition& finer) {
    Partition result = finer;
    for (Part& part : result) {
        part.values.insert(part.values.begin(), coarse.values.begin(), coarse.values.end());
        for (std::size_t& index : part.frames) index = coarse.frames[index];
    }
    return result;
}

std::size_t alternations(std::span<const Frame> frames, const Partition& partition) {
    const auto positions = positionsOf(frames).groups;
    std::vector<std::size_t> partOf(frames.size(), 0);
    for (std::size_t p = 0; p < partition.size(); ++p) {
        for (const std::size_t index : partition[p].frames) partOf[index] = p;
    }
    std::size_t count = 0;
    for (std::size_t k = 1; k < positions.size(); ++k)
        count += partOf[positions[k].front()] != partOf[positions[k - 1].front()] ? 1 : 0;
    return count;
}

Partition separateCopies(std::span<const Frame> frames) {
    Partition partition;
    using Place = std::array<double, 3>;  // 0 of frames without one
    std::map<std::tuple<std::string_view, int, Place>, std::size_t> seen;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const std::string& uid = frames[i].instance->sopInstanceUid;
        Place place{};
        if (frames[i].plane) {
            const glm::dvec3 rounded = glm::round(frames[i].plane->positionMm / kSamePositionMm);
            place = {rounded.x, rounded.y, rounded.z};
        }
        const std::size_t copy = uid.empty() ? 0 : seen[{uid, frames[i].number, place}]++;
        while (partition.size() <= copy) partition.push_back({{std::to_string(partition.size() + 1)}, {}});
        partition[copy].frames.push_back(i);
    }
    return partition;
}

Partition separateRepetitions(std::span<const Frame> frames) {
    Partition partition(2);
    partition[0].values = {"first"};
    partition[1].values = {"others"};
    for (const auto& group : positionsOf(frames).groups) {
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
    const auto [positions, alongMm] = positionsOf(frames);
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
