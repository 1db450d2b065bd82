#include "dicom/split/partition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "dicom/read/date_time.h"

namespace macula::dicom {

namespace {

// Numbers before words; of several numbers the first that differs counts: 1\\2 is before 1\\10.
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
        // The distance is taken to the group's first, so that a group cannot grow along a chain of small
        // distances.
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

namespace {

// The value of a number or a time, by which frames can be ordered.
std::optional<double> orderedValue(const Attribute& attribute, std::string_view text) {
    return attribute.kind == Attribute::Kind::text ? secondsOfEither(text) : numberOf(text);
}

// The value expected for each rank at one position, interpolated from two others.
std::vector<double> expectedValues(const std::vector<double>& a, const std::vector<double>& b, double share) {
    std::vector<double> values;
    for (std::size_t rank = 0; rank < a.size(); ++rank)
        values.push_back(a[rank] + share * (b[rank] - a[rank]));
    return values;
}

// The rank whose value is as good as `value`; nothing when two might be meant.
std::optional<std::size_t> rankOf(const std::vector<double>& expected, double value) {
    constexpr double kClear = 0.3;  // of the distance to the next rank
    std::size_t nearest = 0;
    for (std::size_t rank = 1; rank < expected.size(); ++rank) {
        if (std::abs(value - expected[rank]) < std::abs(value - expected[nearest])) nearest = rank;
    }
    for (std::size_t rank = 0; rank < expected.size(); ++rank) {
        if (rank != nearest &&
            std::abs(value - expected[nearest]) > kClear * std::abs(expected[rank] - expected[nearest])) {
            return {};
        }
    }
    return nearest;
}

// Positions in which a rank is missing.
class Completer {
  public:
    // `groups` are sorted by value. Nothing when too few of them are whole, or a value is no number.
    static std::optional<Completer> of(std::span<const Frame> frames, const Attribute& attribute,
                                       std::size_t place, const std::vector<std::vector<std::size_t>>& groups,
                                       const std::vector<double>& alongMm) {
        Completer completer;
        for (const auto& group : groups) completer.ranks_ = std::max(completer.ranks_, group.size());
        for (std::size_t k = 0; k < groups.size(); ++k) {
            std::vector<double> values;
            for (const std::size_t index : groups[k]) {
                const auto value = orderedValue(attribute, frames[index].attributes[place]);
                if (!value) return {};
                values.push_back(*value);
            }
            if (values.size() == completer.ranks_) completer.whole_.emplace_back(alongMm[k], values);
            completer.values_.push_back(std::move(values));
        }
        if (completer.whole_.size() < 2 || 4 * completer.whole_.size() < 3 * groups.size()) return {};
        return completer;
    }

    std::size_t ranks() const { return ranks_; }

    // The rank of each frame of group `k`, which is at `alongMm`; empty when that is not clear.
    std::vector<std::size_t> ranksOf(std::size_t k, double alongMm) const {
        const auto after = std::find_if(whole_.begin(), whole_.end(),
                                        [&](const auto& entry) { return entry.first >= alongMm; });
        // Interpolates between two whole positions, or extrapolates from the nearest two.
        const auto last = std::clamp(after, whole_.begin() + 1, whole_.end() - 1);
        const auto& [firstMm, first] = *(last - 1);
        const double share = (alongMm - firstMm) / (last->first - firstMm);
        const std::vector<double> expected = expectedValues(first, last->second, share);
        std::vector<std::size_t> ranks;
        for (const double value : values_[k]) {
            const auto rank = rankOf(expected, value);
            if (!rank || (!ranks.empty() && *rank <= ranks.back())) return {};
            ranks.push_back(*rank);
        }
        return ranks;
    }

  private:
    std::size_t ranks_ = 0;
    std::vector<std::vector<double>> values_;                    // of each group
    std::vector<std::pair<double, std::vector<double>>> whole_;  // the place along the normal, and its values
};

}  // namespace

Partition partitionByRank(std::span<const Frame> frames, const SplitRules& rules, std::size_t attribute,
                          bool mayLack) {
    std::vector<double> alongMm;
    auto positions = positionsOf(frames, alongMm);
    if (positions.empty()) return {};
    const auto& valueOf = [&](std::size_t index) -> const std::string& {
        return frames[index].attributes[attribute];
    };
    bool isWhole = true;
    for (auto& group : positions) {
        isWhole = isWhole && group.size() == positions.front().size();
        std::stable_sort(group.begin(), group.end(),
                         [&](std::size_t a, std::size_t b) { return before(valueOf(a), valueOf(b)); });
        for (std::size_t rank = 0; rank < group.size(); ++rank) {
            if (valueOf(group[rank]).empty()) return {};
            if (rank > 0 &&
                sameValue(rules.attributes[attribute], valueOf(group[rank - 1]), valueOf(group[rank]))) {
                return {};
            }
        }
    }
    if (!isWhole && !mayLack) return {};
    std::optional<Completer> completer;
    if (!isWhole) {
        completer = Completer::of(frames, rules.attributes[attribute], attribute, positions, alongMm);
        if (!completer) return {};
    }
    Partition partition(completer ? completer->ranks() : positions.front().size());
    for (std::size_t k = 0; k < positions.size(); ++k) {
        const auto& group = positions[k];
        const bool lacks = group.size() < partition.size();
        const auto ranks = lacks ? completer->ranksOf(k, alongMm[k]) : std::vector<std::size_t>{};
        if (lacks && ranks.empty()) return {};
        for (std::size_t n = 0; n < group.size(); ++n)
            partition[lacks ? ranks[n] : n].frames.push_back(group[n]);
    }
    for (Part& part : partition) {
        part.values = {valueOf(part.frames.front())};
        std::sort(part.frames.begin(), part.frames.end());
    }
    return partition;
}

Partition partitionByRuns(std::span<const Frame> frames, std::size_t attribute, std::size_t count) {
    std::vector<std::pair<double, std::size_t>> times;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const auto seconds = secondsOfEither(frames[i].attributes[attribute]);
        if (!seconds) return {};
        times.emplace_back(*seconds, i);
    }
    std::sort(times.begin(), times.end());
    std::vector<std::pair<double, std::size_t>> pauses;  // and the frame after it
    for (std::size_t i = 1; i < times.size(); ++i) {
        const double pause = times[i].first - times[i - 1].first;
        if (pause > 0.0) pauses.emplace_back(pause, i);
    }
    if (count < 2 || pauses.size() + 1 < count) return {};
    std::stable_sort(pauses.begin(), pauses.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<std::size_t> begins{0};
    for (std::size_t run = 0; run + 1 < count; ++run) begins.push_back(pauses[run].second);
    std::sort(begins.begin(), begins.end());
    begins.push_back(times.size());
    Partition partition;
    for (std::size_t run = 0; run < count; ++run) {
        Part part{{frames[times[begins[run]].second].attributes[attribute]}, {}};
        for (std::size_t i = begins[run]; i < begins[run + 1]; ++i) part.frames.push_back(times[i].second);
        std::sort(part.frames.begin(), part.frames.end());
        partition.push_back(std::move(part));
    }
    return partition;
}

Partition separateLattices(std::span<const Frame> frames) {
    constexpr double kToleranceOfStep = 0.02;
    constexpr std::size_t kLeastFrames = 6;
    std::vector<double> alongMm;
    const auto positions = positionsOf(frames, alongMm);
    if (positions.size() < kLeastFrames || positions.size() != frames.size()) return {};
    std::vector<double> steps;
    for (std::size_t k = 2; k < alongMm.size(); ++k) steps.push_back(alongMm[k] - alongMm[k - 2]);
    std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2),
                     steps.end());
    const double step = steps[steps.size() / 2];
    Partition partition{{{"1"}, {}}, {{"2"}, {}}};
    std::array<double, 2> lastMm{};
    for (std::size_t k = 0; k < positions.size(); ++k) {
        // The step is taken from the frame before, so that rounding errors do not add up.
        const auto isOn = [&](std::size_t lattice) {
            if (partition[lattice].frames.empty()) return true;
            const double multiple = (alongMm[k] - lastMm[lattice]) / step;
            return std::round(multiple) >= 1.0 &&
                   std::abs(multiple - std::round(multiple)) <= kToleranceOfStep;
        };
        const std::size_t lattice = isOn(0) ? 0 : 1;
        if (!isOn(lattice)) return {};
        partition[lattice].frames.push_back(positions[k].front());
        lastMm[lattice] = alongMm[k];
    }
    if (partition[1].frames.empty()) return {};
    // Half a step apart they are one lattice of half the step, from which slices are missing.
    const double apart = (lastMm[1] - lastMm[0]) / step;
    if (std::abs(apart - std::floor(apart) - 0.5) <= kToleranceOfStep) return {};
    for (Part& part : partition) std::sort(part.frames.begin(), part.frames.end());
    return partition;
}

std::size_t alternations(std::span<const Frame> frames, const Partition& partition) {
    std::vector<double> alongMm;
    const auto positions = positionsOf(frames, alongMm);
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
