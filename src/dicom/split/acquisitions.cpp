#include "dicom/split/acquisitions.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "dicom/split/frame_order.h"

namespace macula::dicom {

namespace {

constexpr double kToleranceOfStep = 0.02;
constexpr std::size_t kMostLattices = 6;
constexpr std::size_t kLeastFrames = 3;  // in a lattice

// Assigns frames, added in ascending order, to lattices that all have one step.
class Lattices {
  public:
    explicit Lattices(double stepMm) : stepMm_(stepMm) {}

    // False if the frame lies on none of them, and there are too many to begin another.
    bool add(double alongMm, std::size_t frame) {
        std::size_t best = lastMm_.size();
        double bestMultiple = 0.0;
        for (std::size_t n = 0; n < lastMm_.size(); ++n) {
            // Measures from the frame before, so that rounding errors do not add up.
            const double multiple = (alongMm - lastMm_[n]) / stepMm_;
            const double whole = std::round(multiple);
            if (whole < 1.0 || std::abs(multiple - whole) > kToleranceOfStep) continue;
            if (best < lastMm_.size() && whole >= bestMultiple) continue;
            best = n;
            bestMultiple = whole;
        }
        if (best == lastMm_.size()) {
            if (best == kMostLattices) return false;
            lastMm_.push_back(alongMm);
            partition_.push_back({{std::to_string(best + 1)}, {frame}});
            return true;
        }
        missing_ += static_cast<std::size_t>(bestMultiple) - 1;
        lastMm_[best] = alongMm;
        partition_[best].frames.push_back(frame);
        return true;
    }

    std::size_t missing() const { return missing_; }
    Partition partition() && { return std::move(partition_); }

    // Whether all of them together are one lattice with a fraction of the step, which lacks slices.
    bool areOne() const {
        const auto count = double(lastMm_.size());
        return std::ranges::all_of(lastMm_, [&](double lastMm) {
            const double share = (lastMm - lastMm_.front()) / stepMm_ * count;
            return std::abs(share - std::round(share)) <= kToleranceOfStep * count;
        });
    }

  private:
    double stepMm_;
    std::vector<double> lastMm_;
    std::size_t missing_ = 0;
    Partition partition_;
};

// Distances that may be the step of several lattices: the median distance from a frame to the next, the next
// but one and so on; and the widest to the next, which is the step where the lattices do not overlap.
std::vector<double> possibleSteps(const std::vector<double>& alongMm) {
    std::vector<double> possible;
    for (std::size_t apart = 1; apart <= kMostLattices && apart < alongMm.size(); ++apart) {
        std::vector<double> steps;
        for (std::size_t k = apart; k < alongMm.size(); ++k) steps.push_back(alongMm[k] - alongMm[k - apart]);
        if (apart == 1) possible.push_back(*std::ranges::max_element(steps));
        const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
        std::nth_element(steps.begin(), middle, steps.end());
        possible.push_back(*middle);
    }
    return possible;
}

}  // namespace

Partition partitionByRuns(std::span<const std::optional<double>> values, std::size_t count) {
    std::vector<std::pair<double, std::size_t>> sorted;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!values[i]) return {};
        sorted.emplace_back(*values[i], i);
    }
    std::ranges::sort(sorted);
    std::vector<std::pair<double, std::size_t>> pauses;  // each pause, and the frame after it
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        const double pause = sorted[i].first - sorted[i - 1].first;
        if (pause > 0.0) pauses.emplace_back(pause, i);
    }
    if (count < 2 || pauses.size() + 1 < count) return {};
    std::ranges::stable_sort(pauses, [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<std::size_t> begins{0};
    for (std::size_t run = 0; run + 1 < count; ++run) begins.push_back(pauses[run].second);
    std::ranges::sort(begins);
    begins.push_back(sorted.size());
    Partition partition;
    for (std::size_t run = 0; run < count; ++run) {
        Part part;
        for (std::size_t i = begins[run]; i < begins[run + 1]; ++i) part.frames.push_back(sorted[i].second);
        std::ranges::sort(part.frames);
        partition.push_back(std::move(part));
    }
    return partition;
}

Partition partitionByWays(std::span<const Frame> frames) {
    const auto numbers = instanceNumbers(frames);
    std::vector<std::pair<double, std::size_t>> sorted;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        if (!numbers[i] || !frames[i].plane) return {};
        sorted.emplace_back(*numbers[i], i);
    }
    std::ranges::sort(sorted);
    Partition partition;
    double lastMm = 0.0;
    double direction = 0.0;
    for (std::size_t n = 0; n < sorted.size(); ++n) {
        if (n > 0 && sorted[n].first == sorted[n - 1].first) return {};
        const std::size_t frame = sorted[n].second;
        const double alongMm = glm::dot(frames[frame].plane->positionMm, frames[0].plane->normal());
        const double step = alongMm - lastMm;
        if (partition.empty() || std::abs(step) <= kSamePositionMm || step * direction < 0.0) {
            partition.emplace_back();
            direction = 0.0;
        } else if (direction == 0.0) {
            direction = step;
        }
        partition.back().frames.push_back(frame);
        lastMm = alongMm;
    }
    if (partition.size() < 2) return {};
    for (Part& part : partition) std::ranges::sort(part.frames);
    return partition;
}

Partition separateLattices(std::span<const Frame> frames) {
    constexpr std::size_t kMostMissing = 10;  // at most one in this many frames
    const Positions positions = positionsOf(frames);
    if (positions.groups.size() < 2 * kLeastFrames || positions.groups.size() != frames.size()) return {};
    Partition best;
    for (const double stepMm : possibleSteps(positions.alongMm)) {
        Lattices lattices(stepMm);
        bool fits = true;
        for (std::size_t k = 0; k < positions.groups.size() && fits; ++k)
            fits = lattices.add(positions.alongMm[k], positions.groups[k].front());
        if (!fits || lattices.areOne() || kMostMissing * lattices.missing() > frames.size()) continue;
        Partition partition = std::move(lattices).partition();
        const auto isFew = [](const Part& part) { return part.frames.size() < kLeastFrames; };
        if (partition.size() < 2 || std::ranges::any_of(partition, isFew)) continue;
        if (best.empty() || partition.size() < best.size()) best = std::move(partition);
    }
    for (Part& part : best) std::ranges::sort(part.frames);
    return best;
}

}  // namespace macula::dicom
