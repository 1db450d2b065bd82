#include "registration/rival.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace macula::registration {

namespace {

constexpr double kStepMm = 5.0;  // a third of the spacing of cervical vertebrae, the closest in a spine
constexpr int kStepsEachWay = 32;
constexpr double kApartMm = 10.0;  // nearer places are the same answer
constexpr std::size_t kMostPeaks = 3;
constexpr double kLeastDepth = 1e-4;  // of a likeness from 1 to 2: below the differences between point sets

constexpr std::size_t kAlong = 5;  // index in Parameters of the shift along the patient

double shiftMm(const Parameters& a, const Parameters& b) {
    return std::hypot(a[3] - b[3], a[4] - b[4], a[5] - b[5]);
}

// The scores of the answer moved along the patient.
class Profile {
  public:
    Profile(const Comparison& on, const Parameters& answer) : answer_(answer) {
        for (int n = -kStepsEachWay; n <= kStepsEachWay; ++n) scores_.push_back(on.score(movedBy(n)));
    }

    // The highest peaks that lie apart from the answer.
    std::vector<Parameters> peaks() const {
        std::vector<int> found;
        for (int n = -kStepsEachWay; n <= kStepsEachWay; ++n) {
            if (std::abs(n) * kStepMm < kApartMm || !std::isfinite(at(n))) continue;
            if (at(n) >= at(n - 1) && at(n) > at(n + 1)) found.push_back(n);
        }
        std::ranges::stable_sort(found, [this](int a, int b) { return at(a) > at(b); });
        found.resize(std::min(found.size(), kMostPeaks));
        std::vector<Parameters> places;
        for (const int n : found) places.push_back(movedBy(n));
        return places;
    }

    // The lowest score on the way to `place`; of the whole profile if `place` is not on it.
    double floorTowards(const Parameters& place) const {
        const double along = place[kAlong] - answer_[kAlong];
        const bool isAlong = std::abs(along) >= kApartMm && std::abs(along) <= kStepsEachWay * kStepMm;
        double least = std::numeric_limits<double>::infinity();
        for (int n = -kStepsEachWay; n <= kStepsEachWay; ++n) {
            const bool isBetween = n * along >= 0.0 && std::abs(n) * kStepMm <= std::abs(along);
            if (std::isfinite(at(n)) && (isBetween || !isAlong)) least = std::min(least, at(n));
        }
        return least;
    }

  private:
    double at(int n) const {
        if (std::abs(n) > kStepsEachWay) return -std::numeric_limits<double>::infinity();
        const int place = n + kStepsEachWay;
        return scores_[std::size_t(place)];
    }
    Parameters movedBy(int n) const {
        Parameters moved = answer_;
        moved[kAlong] += n * kStepMm;
        return moved;
    }

    Parameters answer_;
    std::vector<double> scores_;
};

}  // namespace

std::optional<Rival> strongestRival(const Comparison& on, const Parameters& answer,
                                    std::span<const Parameters> others,
                                    const std::function<Highest(const Parameters&)>& search) {
    const Profile profile(on, answer);
    std::vector<Parameters> starts = profile.peaks();
    for (const Parameters& other : others.first(std::min(others.size(), kMostPeaks)))
        if (shiftMm(other, answer) >= kApartMm) starts.push_back(other);
    const double highest = on.score(answer);
    std::optional<Rival> strongest;
    for (const Parameters& start : starts) {
        Rival rival{.place = search(start)};
        rival.shiftMm = shiftMm(rival.place.at, answer);
        if (rival.shiftMm < kApartMm || !std::isfinite(rival.place.value)) continue;  // the search led back
        const double floor = std::min({profile.floorTowards(rival.place.at), highest, rival.place.value});
        const double depth = highest - floor;
        // If the likeness does not fall on the way, nothing distinguishes the two places.
        rival.share = depth < kLeastDepth ? 1.0 : (rival.place.value - floor) / depth;
        if (!strongest || rival.share > strongest->share) strongest = rival;
    }
    return strongest;
}

}  // namespace macula::registration
