#include "pipeline/hybrid/model/error_trend.h"

#include <algorithm>
#include <cmath>

namespace macula::hybrid {

void ErrorTrend::add(double seconds, double error) {
    if (!(error > 0.0) || !std::isfinite(error) || !std::isfinite(seconds)) return;
    if (means_.empty() || seconds >= means_.back().beganAt + options_.leastSeconds)
        means_.push_back({.beganAt = seconds});
    if (means_.size() > options_.window) means_.erase(means_.begin());
    Mean& mean = means_.back();
    mean.seconds += seconds;
    mean.logError += std::log(error);
    mean.count += 1.0;
}

std::optional<double> ErrorTrend::fallPerSecond() const {
    if (means_.size() < std::max<std::size_t>(options_.window, 2)) return {};
    std::vector<double> slopes;
    for (std::size_t i = 0; i < means_.size(); ++i)
        for (std::size_t j = i + 1; j < means_.size(); ++j) {
            const Mean& a = means_[i];
            const Mean& b = means_[j];
            const double apart = b.seconds / b.count - a.seconds / a.count;
            if (apart > 0.0) slopes.push_back((b.logError / b.count - a.logError / a.count) / apart);
        }
    if (slopes.empty()) return {};
    const auto middle = slopes.begin() + static_cast<std::ptrdiff_t>(slopes.size() / 2);
    std::nth_element(slopes.begin(), middle, slopes.end());
    return -*middle;
}

bool ErrorTrend::isFlat() const {
    const std::optional<double> fall = fallPerSecond();
    return fall && *fall < options_.leastFallPerSecond;
}

}  // namespace macula::hybrid
