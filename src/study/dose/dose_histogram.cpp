#include "study/dose/dose_histogram.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace macula::study {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

}  // namespace

DoseHistogram::DoseHistogram(std::vector<float> samples) : samples_(std::move(samples)), mean_(kNone) {
    if (samples_.empty()) return;
    std::ranges::sort(samples_);
    double sum = 0.0;
    for (const float sample : samples_) sum += double(sample);  // ascending: the small ones are not lost
    mean_ = sum / double(samples_.size());
}

double DoseHistogram::minimum() const {
    return isEmpty() ? kNone : double(samples_.front());
}

double DoseHistogram::maximum() const {
    return isEmpty() ? kNone : double(samples_.back());
}

double DoseHistogram::doseAt(double share) const {
    if (isEmpty()) return kNone;
    const double last = double(samples_.size() - 1);
    const double rank =
        std::clamp(double(samples_.size()) * (1.0 - std::clamp(share, 0.0, 1.0)) - 0.5, 0.0, last);
    const auto below = std::size_t(rank);
    const std::size_t above = std::min(below + 1, samples_.size() - 1);
    const double part = rank - double(below);
    return (1.0 - part) * double(samples_[below]) + part * double(samples_[above]);
}

double DoseHistogram::shareAt(double dose) const {
    if (isEmpty()) return kNone;
    if (dose <= minimum()) return 1.0;
    if (!(dose <= maximum())) return 0.0;
    const auto first = std::ranges::lower_bound(samples_, dose, {}, [](float s) { return double(s); });
    double rank = double(first - samples_.begin());
    if (const double above = double(*first); above > dose) {
        const double below = double(*(first - 1));
        rank += (dose - below) / (above - below) - 1.0;
    }
    return 1.0 - (rank + 0.5) / double(samples_.size());
}

}  // namespace macula::study
