// How long work will still take, from what is done and how long that took.
#include "viewer/status/time_left.h"

#include <gtest/gtest.h>

namespace macula::viewer {
namespace {

using std::chrono::seconds;

TEST(TimeLeft, FollowsFromWhatIsDone) {
    const TimeLeft::Clock::time_point start{};
    TimeLeft left;
    left.begin(start);
    EXPECT_EQ(left.after(0.25, start + seconds(10)), seconds(30));
    EXPECT_EQ(left.after(1.0, start + seconds(10)), seconds(0));
    EXPECT_FALSE(left.after(0.5, start + seconds(1))) << "too early to say";
    EXPECT_FALSE(left.after(0.001, start + seconds(10)));
    EXPECT_FALSE(left.after(0.0, start + seconds(10)));
    EXPECT_FALSE(left.after(std::numeric_limits<double>::quiet_NaN(), start + seconds(10)));
}

TEST(TimeLeft, IsSaidAsPeopleSayIt) {
    EXPECT_EQ(timeLeftText(seconds(0)), QStringLiteral("0 s left"));
    EXPECT_EQ(timeLeftText(seconds(11)), QStringLiteral("15 s left"));
    EXPECT_EQ(timeLeftText(seconds(119)), QStringLiteral("120 s left"));
    EXPECT_EQ(timeLeftText(seconds(160)), QStringLiteral("3 min left"));
}

}  // namespace
}  // namespace macula::viewer
