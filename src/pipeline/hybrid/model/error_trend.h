// Whether an error that is measured from time to time still falls, however noisy single measurements are.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace macula::hybrid {

struct ErrorTrendOptions {
    // An error that falls by less than this part of itself per second of training counts as flat.
    double leastFallPerSecond = 0.002;
    // The trend is that of `window` means, each over at least `leastSeconds`: faster measurements are
    // averaged first, because over short times noise hides any trend.
    std::size_t window = 9;
    double leastSeconds = 0.25;
};

// The slope is the median of the slopes between any two means (Theil 1950, Sen 1968), so two outliers among
// nine do not decide it. If the means have independent noise of standard deviation n and are s seconds apart,
// nine of them give the fall per second to about 0.14 n / s.
class ErrorTrend {
  public:
    explicit ErrorTrend(const ErrorTrendOptions& options = {}) : options_(options) {}

    // `seconds` of training until now, never less than before. Ignores errors that are not finite or not
    // above 0.
    void add(double seconds, double error);
    // Starts over, because the next errors measure something else.
    void forget() { means_.clear(); }

    // The relative fall of the error: 0.01 means by a hundredth in a second. Nothing before the window is
    // full.
    std::optional<double> fallPerSecond() const;
    bool isFlat() const;

  private:
    struct Mean {
        double beganAt = 0.0;
        double seconds = 0.0;  // sums over `count`
        double logError = 0.0;
        double count = 0.0;
    };

    ErrorTrendOptions options_;
    std::vector<Mean> means_;  // the last one may still grow
};

}  // namespace macula::hybrid
