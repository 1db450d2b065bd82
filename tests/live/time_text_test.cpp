#include "live/store/time_text.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>
#include <limits>

namespace macula::live {
namespace {

constexpr std::int64_t kMs = 1'700'000'000'123;

std::string localTimeIn(const char* zone, std::int64_t ms) {
    const char* before = std::getenv("TZ");
    const std::string kept = before == nullptr ? "" : before;
    setenv("TZ", zone, 1);
    tzset();
    const std::string text = localTime(ms);
    before == nullptr ? unsetenv("TZ") : setenv("TZ", kept.c_str(), 1);
    tzset();
    return text;
}

TEST(TimeText, IsInUtcForPrograms) {
    EXPECT_EQ(utcTime(0), "1970-01-01T00:00:00.000Z");
    EXPECT_EQ(utcTime(kMs), "2023-11-14T22:13:20.123Z");
    EXPECT_EQ(utcTime(-1), "1969-12-31T23:59:59.999Z");
    EXPECT_FALSE(utcTime(std::numeric_limits<std::int64_t>::max()).empty());
}

TEST(TimeText, IsInTheTimeOfThePlaceForPeople) {
    EXPECT_EQ(localTimeIn("UTC0", kMs), "2023-11-14T22:13:20+00:00");
    EXPECT_EQ(localTimeIn("CET-1", kMs), "2023-11-14T23:13:20+01:00");
    EXPECT_EQ(localTimeIn("NST3:30", kMs), "2023-11-14T18:43:20-03:30");
}

}  // namespace
}  // namespace macula::live
