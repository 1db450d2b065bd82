// Whether an error that is measured now and then still falls, however noisy single measurements are.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace macula::hybrid {

struct ErrorTrendOptions {
    // An error that falls by less than this part of itself in a second of training counts as flat.
    double leastFallPerSecond = 0.002;
    // The trend is that of so many means, each over at least so many seconds: measurements that come faster
    // than that are averaged first, because over short times noise hides any trend.
    std::size_t window = 9;
    double leastSeconds = 0.25;
};

// The slope is the median of those between any two of the means (Theil 1950, Sen 1968): no two of nine that
// are far off decide it. With independent noise of standard deviation n for each mean, s seconds apart, nine
// of them tell the fall per second to about 0.14 n / s.
class ErrorTrend {
  public:
    explicit ErrorTrend(const ErrorTrendOptions& options = {}) : options_(options) {}

    // `seconds` of training until now, never less than before. An error that is not above 0 and finite is
    // left out.
    void add(double seconds, double error);
    // Starts anew: the errors that follow are of something else.
    void forget() { means_.clear(); }

    // The fall of the error, as a part of it: 0.01 means that it falls by a hundredth in a second. Nothing
    // before the window is full.
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
