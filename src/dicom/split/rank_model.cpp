#include "dicom/split/rank_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace macula::dicom {

namespace {

// As fractions of the usual distance between ranks.
constexpr double kTolerance = 0.5;
constexpr double kExactTolerance = 0.15;
constexpr double kClear = 0.3;  // beyond this a value may belong to two ranks

double medianOf(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double meanOf(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum / double(values.size());
}

}  // namespace

// The median over positions of the distance from each rank to the next.
void RankModel::findUsualDistances() {
    for (std::size_t rank = 1; rank < ranks_; ++rank) {
        std::vector<double> distances;
        for (const auto& values : sorted_) {
            if (!values.empty()) distances.push_back(values[rank] - values[rank - 1]);
        }
        usual_.push_back(medianOf(std::move(distances)));
    }
}

double RankModel::leastDistance() const {
    return *std::ranges::min_element(usual_);
}

bool RankModel::hasUsualDistances(std::size_t position, double tolerance) const {
    const std::vector<double>& values = sorted_[position];
    if (values.empty()) return false;
    double usualTotal = 0.0;
    for (const double distance : usual_) usualTotal += distance;
    const double factor = (values.back() - values.front()) / usualTotal;
    if (!(factor >= 0.5 && factor <= 2.0)) return false;
    for (std::size_t rank = 1; rank < ranks_; ++rank) {
        const double distance = (values[rank] - values[rank - 1]) / factor;
        if (!(std::abs(distance - usual_[rank - 1]) <= tolerance * usual_[rank - 1])) return false;
    }
    return true;
}

// The values expected from the nearest regular positions on both sides; at an end from the nearest two.
std::optional<std::vector<double>> RankModel::expectedAt(std::size_t position) const {
    std::vector<std::size_t> below;
    std::vector<std::size_t> above;
    for (std::size_t k = position; k-- > 0 && below.size() < 2;) {
        if (regular_[k]) below.push_back(k);
    }
    for (std::size_t k = position + 1; k < regular_.size() && above.size() < 2; ++k) {
        if (regular_[k]) above.push_back(k);
    }
    std::size_t a = 0;
    std::size_t b = 0;
    if (!below.empty() && !above.empty()) {
        a = below[0];
        b = above[0];
    } else if (below.size() == 2) {
        a = below[1];
        b = below[0];
    } else if (above.size() == 2) {
        a = above[0];
        b = above[1];
    } else {
        return {};
    }
    const double share = (alongMm_[position] - alongMm_[a]) / (alongMm_[b] - alongMm_[a]);
    std::vector<double> expected;
    for (std::size_t rank = 0; rank < ranks_; ++rank)
        expected.push_back(sorted_[a][rank] + share * (sorted_[b][rank] - sorted_[a][rank]));
    return expected;
}

// Whether values are as expected from their neighbours at most positions. The others become irregular, the
// worst first, because it spoils the expectation for its neighbours.
void RankModel::findSteadiness() {
    const auto errorAt = [&](std::size_t k) {
        const auto expected = expectedAt(k);
        return expected ? std::abs(meanOf(sorted_[k]) - meanOf(*expected)) : 0.0;
    };
    std::vector<double> errors;
    for (std::size_t k = 0; k < regular_.size(); ++k) {
        if (regular_[k]) errors.push_back(errorAt(k));
    }
    if (errors.size() < 3) return;
    const double allowed = kTolerance * leastDistance();
    const auto good = std::ranges::count_if(errors, [&](double e) { return e <= 0.5 * allowed; });
    // Half is enough, because a wrong position spoils the expectation on both sides of it.
    isSteady_ = 2 * good >= std::ssize(errors);
    while (isSteady_) {
        std::size_t worst = 0;
        double error = allowed;
        for (std::size_t k = 0; k < regular_.size(); ++k) {
            if (!regular_[k] || errorAt(k) <= error) continue;
            error = errorAt(k);
            worst = k;
        }
        if (error <= allowed) return;
        regular_[worst] = false;
    }
}

// Whether all values of a rank come before the next, and no pause within a rank could be one between ranks.
void RankModel::findBlocks() {
    constexpr double kTimesUsual = 4.0;
    std::vector<std::vector<double>> blocks(ranks_);
    for (std::size_t k = 0; k < sorted_.size(); ++k) {
        for (std::size_t rank = 0; rank < ranks_ && regular_[k]; ++rank)
            blocks[rank].push_back(sorted_[k][rank]);
    }
    std::vector<double> inside;
    double between = std::numeric_limits<double>::infinity();
    for (std::size_t rank = 0; rank < ranks_; ++rank) {
        std::ranges::sort(blocks[rank]);
        for (std::size_t n = 1; n < blocks[rank].size(); ++n)
            inside.push_back(blocks[rank][n] - blocks[rank][n - 1]);
        if (rank > 0) between = std::min(between, blocks[rank].front() - blocks[rank - 1].back());
    }
    if (inside.empty() || between <= 0.0) return;
    const double longest = *std::ranges::max_element(inside);
    const double usual = medianOf(std::move(inside));
    isInBlocks_ = longest <= 0.5 * between || (longest <= between && longest <= kTimesUsual * usual);
}

std::optional<RankModel> RankModel::of(const Positions& positions,
                                       std::span<const std::optional<double>> values, std::size_t ranks) {
    RankModel model;
    model.ranks_ = ranks;
    model.values_ = values;
    model.alongMm_ = positions.alongMm;
    std::size_t whole = 0;
    for (const auto& group : positions.groups) {
        std::vector<double> sorted;
        for (const std::size_t frame : group) {
            if (values[frame]) sorted.push_back(*values[frame]);
        }
        std::ranges::sort(sorted);
        const bool isWhole = sorted.size() == ranks && group.size() == ranks &&
                             std::ranges::adjacent_find(sorted) == sorted.end();
        whole += isWhole ? 1 : 0;
        model.sorted_.push_back(isWhole ? std::move(sorted) : std::vector<double>{});
    }
    const auto isEnough = [&](std::size_t count) {
        return count >= 2 && 4 * count >= 3 * positions.groups.size();
    };
    if (ranks < 2 || !isEnough(whole)) return {};
    model.findUsualDistances();
    std::size_t exact = 0;
    for (std::size_t k = 0; k < positions.groups.size(); ++k) {
        model.regular_.push_back(model.hasUsualDistances(k, kTolerance));
        exact += model.hasUsualDistances(k, kExactTolerance) ? 1 : 0;
    }
    const auto countRegular = [&] {
        return static_cast<std::size_t>(std::ranges::count(model.regular_, true));
    };
    if (!isEnough(countRegular())) return {};
    model.findSteadiness();
    if (!isEnough(countRegular())) return {};
    model.isExact_ = ranks > 2 && 10 * exact >= 9 * whole;
    model.findBlocks();
    return model;
}

std::vector<std::optional<std::size_t>> RankModel::ranksOf(std::size_t position,
                                                           std::span<const std::size_t> frames) const {
    std::vector<std::optional<std::size_t>> ranks(frames.size());
    const auto expected = regular_[position] ? std::optional(sorted_[position])
                          : isSteady_        ? expectedAt(position)
                                             : std::nullopt;
    if (!expected) return ranks;
    for (std::size_t n = 0; n < frames.size(); ++n) {
        if (!values_[frames[n]]) continue;
        const double value = *values_[frames[n]];
        const auto distanceTo = [&](double other) { return std::abs(value - other); };
        const auto nearest =
            static_cast<std::size_t>(std::ranges::min_element(*expected, {}, distanceTo) - expected->begin());
        bool isClear = true;
        for (std::size_t rank = 0; rank < ranks_; ++rank) {
            const double apart = std::abs((*expected)[rank] - (*expected)[nearest]);
            isClear = isClear && (rank == nearest || distanceTo((*expected)[nearest]) <= kClear * apart);
        }
        if (isClear) ranks[n] = nearest;
    }
    return ranks;
}

}  // namespace macula::dicom
