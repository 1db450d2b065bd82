#include "viewer/status/time_left.h"

#include <QCoreApplication>
#include <cmath>

namespace macula::viewer {

namespace {

constexpr std::chrono::seconds kTooEarly{3};
constexpr double kTooLittle = 0.02;
constexpr std::int64_t kSecondsPerMinute = 60;
constexpr std::int64_t kStep = 5;  // seconds that nobody needs to tell apart

struct Words {
    Q_DECLARE_TR_FUNCTIONS(TimeLeft)
};

}  // namespace

std::optional<std::chrono::seconds> TimeLeft::after(double fraction, Clock::time_point now) const {
    const std::chrono::duration<double> passed = now - begun_;
    if (!(fraction > kTooLittle) || passed < kTooEarly) return std::nullopt;
    return std::chrono::seconds(std::llround(passed.count() * std::max(0.0, 1.0 / fraction - 1.0)));
}

QString timeLeftText(std::chrono::seconds left) {
    const std::int64_t seconds = left.count();
    if (seconds >= 2 * kSecondsPerMinute)
        return Words::tr("%1 min left").arg((seconds + kSecondsPerMinute / 2) / kSecondsPerMinute);
    return Words::tr("%1 s left").arg((seconds + kStep - 1) / kStep * kStep);
}

}  // namespace macula::viewer
