#include "pipeline/splat/train/trained_views.h"

#include <algorithm>

#include "pipeline/splat/train/dice.h"

namespace macula::splat {

namespace {

constexpr std::uint64_t kNewEvery = 6;  // steps; docs/peripheral-model.md, "512 views"

}  // namespace

void TrainedViews::forgetStandIns() {
    std::erase_if(views_, [](const TrainedView& view) { return !isPicture(*view.given); });
}

void TrainedViews::tryAllAgain() {
    for (TrainedView& view : views_) view.hasNoRoom = false;
}

// Chooses the next view. In the first round each view once. Of views added later, one every kNewEvery steps,
// so that hundreds of new views in a row do not displace what the others have taught. Otherwise half of the
// time any view, and half of the time one with a probability proportional to its loss.
std::optional<std::size_t> TrainedViews::next(std::uint32_t seed, std::uint64_t steps) const {
    std::vector<std::size_t> known;
    std::optional<std::size_t> firstNew;
    double sum = 0.0;
    for (std::size_t i = 0; i < views_.size(); ++i) {
        if (views_[i].hasNoRoom) continue;
        if (views_[i].loss < 0.0) {
            firstNew = firstNew.value_or(i);
            continue;
        }
        known.push_back(i);
        sum += views_[i].loss;
    }
    const bool isFirstRound = known.size() == steps;
    if (firstNew && (isFirstRound || known.empty() || steps % kNewEvery == 0)) return firstNew;
    if (known.empty()) return std::nullopt;
    Dice dice(seed, steps, 0);
    const double share = dice();
    if (dice() < 0.5 || !(sum > 0.0))
        return known[std::min(static_cast<std::size_t>(share * double(known.size())), known.size() - 1)];
    double left = share * sum;
    std::size_t k = 0;
    while (k + 1 < known.size() && left >= views_[known[k]].loss) left -= views_[known[k++]].loss;
    return known[k];
}

TrainedViews::Means TrainedViews::means() const {
    Means means;
    double weights = 0.0;
    double drawn = 0.0;
    double pictures = 0.0;
    for (const TrainedView& view : views_) {
        if (!isPicture(*view.given)) continue;
        if (view.loss < 0.0 && view.hasNoRoom) continue;
        pictures += 1.0;
        if (view.loss < 0.0) continue;
        means.loss += view.loss;
        means.l1 += view.l1;
        weights += double(view.given->weight);
        drawn += 1.0;
    }
    means.loss = drawn == pictures && drawn > 0.0 ? means.loss / weights : 0.0;
    means.l1 /= std::max(drawn, 1.0);
    return means;
}

}  // namespace macula::splat
