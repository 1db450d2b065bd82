#include "dicom/split/frame_order.h"

#include <algorithm>
#include <utility>

#include "dicom/read/date_time.h"

namespace macula::dicom {

namespace {

constexpr double kSecondsOfDay = 86400.0;

using Values = std::vector<std::optional<double>>;

// Moves the times before the longest pause to the next day, if that pause is most of a day.
void unwrapMidnight(Values& seconds) {
    std::vector<double> sorted;
    for (const auto& value : seconds) {
        if (value) sorted.push_back(*value);
    }
    std::ranges::sort(sorted);
    double longest = kSecondsOfDay / 2.0;
    std::optional<double> begin;  // the first time of the first day
    for (std::size_t n = 1; n < sorted.size(); ++n) {
        if (sorted[n] - sorted[n - 1] <= longest) continue;
        longest = sorted[n] - sorted[n - 1];
        begin = sorted[n];
    }
    if (!begin) return;
    for (auto& value : seconds) {
        if (value && *value < *begin) *value += kSecondsOfDay;
    }
}

Values timesOf(std::span<const Frame> frames, std::size_t attribute) {
    Values seconds;
    std::vector<std::optional<long>> days;
    for (const Frame& frame : frames) {
        const auto moment = momentOf(frame.attributes[attribute]);
        seconds.push_back(moment ? std::optional(moment->seconds) : std::nullopt);
        if (moment) days.push_back(moment->day);
    }
    if (days.empty()) return seconds;
    const auto hasDay = [](const std::optional<long>& day) { return day.has_value(); };
    if (std::ranges::any_of(days, hasDay) && !std::ranges::all_of(days, hasDay))
        return Values(frames.size(), std::nullopt);
    if (std::ranges::all_of(days, [&](const auto& day) { return day == days.front(); }))
        unwrapMidnight(seconds);
    return seconds;
}

}  // namespace

std::vector<std::optional<double>> orderValues(std::span<const Frame> frames, const SplitRules& rules,
                                               std::size_t attribute) {
    if (rules.attributes[attribute].kind == Attribute::Kind::time) return timesOf(frames, attribute);
    Values values;
    for (const Frame& frame : frames) values.push_back(numberOf(frame.attributes[attribute]));
    return values;
}

std::vector<std::optional<double>> instanceNumbers(std::span<const Frame> frames) {
    Values numbers;
    for (const Frame& frame : frames) {
        const Instance& instance = *frame.instance;
        const bool isKnown = instance.instanceNumber && !instance.multiFrame;
        numbers.push_back(isKnown ? std::optional(double(*instance.instanceNumber)) : std::nullopt);
    }
    return numbers;
}

Positions positionsOf(std::span<const Frame> frames, double toleranceMm) {
    std::vector<std::pair<double, std::size_t>> sorted;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        if (!frames[i].plane) return {};
        sorted.emplace_back(glm::dot(frames[i].plane->positionMm, frames[0].plane->normal()), i);
    }
    std::ranges::stable_sort(sorted, {}, [](const auto& entry) { return entry.first; });
    Positions positions;
    for (const auto& [alongMm, index] : sorted) {
        // Measures from the first of the group, so that a group cannot grow along a chain of small distances.
        if (positions.groups.empty() || !(alongMm - positions.alongMm.back() <= toleranceMm)) {
            positions.groups.emplace_back();
            positions.alongMm.push_back(alongMm);
        }
        positions.groups.back().push_back(index);
    }
    return positions;
}

double placeToleranceMm(std::span<const Frame> frames) {
    constexpr double kClear = 10.0;  // distances between clusters are this many times their width
    constexpr double kMostDriftMm = 0.5;
    constexpr std::size_t kLeastClusters = 3;
    std::vector<double> alongMm;
    for (const Frame& frame : frames) {
        if (!frame.plane) return kSamePositionMm;
        alongMm.push_back(glm::dot(frame.plane->positionMm, frames[0].plane->normal()));
    }
    std::ranges::sort(alongMm);
    std::vector<double> stepsMm;
    for (std::size_t n = 1; n < alongMm.size(); ++n) stepsMm.push_back(alongMm[n] - alongMm[n - 1]);
    std::ranges::sort(stepsMm);
    // Looks for the widest step inside clusters, if there are any: then at least one step in three is inside
    // one.
    for (std::size_t inside = stepsMm.size() - std::min(stepsMm.size(), kLeastClusters - 1);
         3 * inside >= alongMm.size() && inside > 0; --inside) {
        const double betweenMm = stepsMm[inside];
        if (betweenMm <= kClear * stepsMm[inside - 1]) continue;
        double widestMm = 0.0;
        double beginMm = alongMm.front();
        for (std::size_t n = 1; n < alongMm.size(); ++n) {
            if (alongMm[n] - alongMm[n - 1] >= betweenMm) beginMm = alongMm[n];
            widestMm = std::max(widestMm, alongMm[n] - beginMm);
        }
        if (widestMm > std::min(kMostDriftMm, betweenMm / kClear)) continue;
        return std::max(kSamePositionMm, 1.5 * widestMm);
    }
    return kSamePositionMm;
}

}  // namespace macula::dicom
