#include "live/store/time_text.h"

#include <fmt/format.h>

#include <cstdlib>
#include <ctime>

namespace macula::live {

namespace {

struct Parts {
    std::time_t seconds = 0;
    int milliseconds = 0;  // 0 to 999, also before 1970
};

Parts partsOf(std::int64_t sinceEpochMs) {
    std::int64_t seconds = sinceEpochMs / 1000;
    std::int64_t rest = sinceEpochMs % 1000;
    if (rest < 0) {
        rest += 1000;
        --seconds;
    }
    return {static_cast<std::time_t>(seconds), static_cast<int>(rest)};
}

std::string dateAndTime(const std::tm& time) {
    return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}", time.tm_year + 1900, time.tm_mon + 1,
                       time.tm_mday, time.tm_hour, time.tm_min, time.tm_sec);
}

}  // namespace

std::string utcTime(std::int64_t sinceEpochMs) {
    const Parts parts = partsOf(sinceEpochMs);
    std::tm time{};
    gmtime_r(&parts.seconds, &time);
    return fmt::format("{}.{:03}Z", dateAndTime(time), parts.milliseconds);
}

std::string localTime(std::int64_t sinceEpochMs) {
    const Parts parts = partsOf(sinceEpochMs);
    std::tm time{};
    localtime_r(&parts.seconds, &time);
    const long minutes = time.tm_gmtoff / 60;
    return fmt::format("{}{}{:02}:{:02}", dateAndTime(time), minutes < 0 ? '-' : '+', std::labs(minutes) / 60,
                       std::labs(minutes) % 60);
}

}  // namespace macula::live
