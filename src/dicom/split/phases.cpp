#include "dicom/split/phases.h"

#include <algorithm>
#include <map>

#include "dicom/split/rank_model.h"

namespace macula::dicom {

namespace {

using Ranks = std::vector<std::optional<std::size_t>>;

// The most common number of frames at a position.
std::size_t usualSize(const Positions& positions) {
    std::map<std::size_t, std::size_t> counts;
    for (const auto& group : positions.groups) ++counts[group.size()];
    std::size_t usual = 0;
    for (const auto& [size, count] : counts) {
        if (usual == 0 || count >= counts[usual]) usual = size;
    }
    return usual;
}

// Ranks by image numbers, as ranks of another value: numbers may run from the last phase to the first.
class NumberRanks {
  public:
    NumberRanks(const RankModel* numbers, const RankModel& values, const Positions& positions,
                std::size_t ranks)
        : model_(numbers) {
        if (model_ == nullptr) return;
        std::map<std::vector<std::size_t>, std::size_t> seen;  // the value's rank for each rank by number
        std::size_t shared = 0;
        for (std::size_t k = 0; k < positions.groups.size(); ++k) {
            if (!model_->isRegular(k) || !values.isRegular(k)) continue;
            const Ranks byNumber = model_->ranksOf(k, positions.groups[k]);
            const Ranks byValue = values.ranksOf(k, positions.groups[k]);
            std::vector<std::size_t> map(ranks);
            for (std::size_t n = 0; n < byNumber.size(); ++n) map[*byNumber[n]] = *byValue[n];
            ++seen[map];
            ++shared;
        }
        const auto usual = std::ranges::max_element(seen, {}, [](const auto& entry) { return entry.second; });
        if (usual == seen.end() || 4 * usual->second < 3 * shared || !model_->isFirm()) {
            model_ = nullptr;
        } else {
            map_ = usual->first;
        }
    }

    bool areKnown() const { return model_ != nullptr; }

    Ranks ranksOf(std::size_t position, const std::vector<std::size_t>& frames) const {
        if (model_ == nullptr) return Ranks(frames.size());
        Ranks ranks = model_->ranksOf(position, frames);
        for (auto& rank : ranks) {
            if (rank) rank = map_[*rank];
        }
        return ranks;
    }

  private:
    const RankModel* model_;
    std::vector<std::size_t> map_;
};

// Puts the frames of one position into the parts, or into `unclear`.
void assign(const std::vector<std::size_t>& frames, const Ranks& byValue, const Ranks& byNumber,
            Phases& phases) {
    enum class Support { none, one, both };
    const auto supportOf = [&](std::size_t n) {
        if (byValue[n] && byNumber[n]) return *byValue[n] == *byNumber[n] ? Support::both : Support::none;
        return byValue[n] || byNumber[n] ? Support::one : Support::none;
    };
    std::vector<bool> isTaken(phases.parts.size(), false);
    std::vector<bool> isPlaced(frames.size(), false);
    // Frames that both value and number support come first; among equals, that with the lowest number, which
    // is their order.
    for (const Support support : {Support::both, Support::one}) {
        for (std::size_t n = 0; n < frames.size(); ++n) {
            if (supportOf(n) != support) continue;
            const std::size_t rank = byValue[n] ? *byValue[n] : *byNumber[n];
            if (isTaken[rank]) continue;
            isTaken[rank] = isPlaced[n] = true;
            phases.parts[rank].frames.push_back(frames[n]);
            if (!byValue[n]) phases.byNumber.push_back(frames[n]);
        }
    }
    for (std::size_t n = 0; n < frames.size(); ++n) {
        if (!isPlaced[n]) phases.unclear.push_back(frames[n]);
    }
}

}  // namespace

std::optional<Phases> phasesByRank(std::span<const Frame> frames,
                                   std::span<const std::optional<double>> values) {
    Positions positions = positionsOf(frames, placeToleranceMm(frames));
    const std::vector<std::optional<double>> numbers = instanceNumbers(frames);
    for (auto& group : positions.groups) {
        std::ranges::stable_sort(group, {}, [&](std::size_t frame) { return numbers[frame].value_or(0.0); });
    }
    const std::size_t ranks = usualSize(positions);
    const auto byValue = RankModel::of(positions, values, ranks);
    if (!byValue) return {};
    const auto byNumber = RankModel::of(positions, numbers, ranks);
    const NumberRanks numberRanks(byNumber ? &*byNumber : nullptr, *byValue, positions, ranks);
    if (!byValue->isFirm() && !numberRanks.areKnown()) return {};
    Phases phases;
    phases.parts.resize(ranks);
    for (std::size_t k = 0; k < positions.groups.size(); ++k) {
        const auto& group = positions.groups[k];
        assign(group, byValue->ranksOf(k, group), numberRanks.ranksOf(k, group), phases);
    }
    constexpr std::size_t kMostUnclear = 5;  // at most one in this many frames
    if (kMostUnclear * phases.unclear.size() > frames.size()) return {};
    for (Part& part : phases.parts) {
        if (part.frames.empty()) return {};
        std::ranges::sort(part.frames);
    }
    std::ranges::sort(phases.unclear);
    std::ranges::sort(phases.byNumber);
    return phases;
}

}  // namespace macula::dicom
