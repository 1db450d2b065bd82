// When a picture that gets samples is shown again, and whether filtered, by a made-up clock.
#include "live/frame/filter_course.h"

#include <gtest/gtest.h>

#include "live/frame/frame_input.h"

namespace macula::live {
namespace {

using std::chrono::milliseconds;

class FilterCourseTest : public testing::Test {
  protected:
    FilterCourse course_;
    FilterCourse::TimePoint now_{};
};

TEST_F(FilterCourseTest, TheFirstIsShownAtOnceAndTheNextWithTwiceTheSamples) {
    course_.begin(2, true);
    EXPECT_FALSE(course_.isDue(1.0, now_));
    EXPECT_FALSE(course_.isWorthShowing());
    EXPECT_TRUE(course_.isDue(2.0, now_));
    course_.showed(2.0, 500.0, now_);
    EXPECT_TRUE(course_.isWorthShowing());
    now_ += milliseconds(1000);
    EXPECT_FALSE(course_.isDue(3.9, now_)) << "the filter takes half of that time";
    EXPECT_TRUE(course_.isDue(4.0, now_));
    EXPECT_FALSE(course_.isDue(4.0, now_ - milliseconds(901))) << "news that nobody can see";
}

// At 64 samples the next doubling is half a minute away on two cores, and the filter takes a hundredth of it.
TEST_F(FilterCourseTest, LaterTheFilterTakesAnEighthOfTheTime) {
    course_.begin(2, true);
    course_.showed(64.0, 250.0, now_);
    EXPECT_FALSE(course_.isDue(66.0, now_ + milliseconds(1999)));
    EXPECT_TRUE(course_.isDue(66.0, now_ + milliseconds(2000)));
    EXPECT_FALSE(course_.isDue(64.0, now_ + milliseconds(9000))) << "nothing is new";
}

// Whatever the number of samples is: noise decides when plain means take over.
TEST_F(FilterCourseTest, TheFilterGoesOnUntilNoiseCannotBeSeen) {
    course_.begin(2, true);
    course_.showed(4096.0, 1.0, now_);
    course_.noiseIs(false, kUnseenNoise);
    EXPECT_TRUE(course_.isFiltered());
    EXPECT_TRUE(course_.isNoisy());
    course_.noiseIs(true, 4.0 * kUnseenNoise);
    EXPECT_TRUE(course_.isFiltered()) << "it is below what was asked for, and can be seen";
    course_.noiseIs(true, kUnseenNoise);
    EXPECT_FALSE(course_.isFiltered());
    EXPECT_FALSE(course_.isNoisy());
    course_.noiseIs(false, 0.5 * kUnseenNoise);
    EXPECT_FALSE(course_.isFiltered()) << "less is asked for, and what cannot be seen stays so";
    EXPECT_TRUE(course_.isDue(4097.0, now_ + FilterCourse::kNewsInterval)) << "plain means cost nothing";
    course_.begin(2, true);
    EXPECT_TRUE(course_.isFiltered()) << "another picture";
    EXPECT_FALSE(course_.isWorthShowing());
}

TEST_F(FilterCourseTest, WithoutAFilterMoreSamplesComeFirst) {
    course_.begin(2, true);
    course_.doWithoutFilter(4);
    EXPECT_FALSE(course_.isFiltered());
    EXPECT_TRUE(course_.isNoisy());
    EXPECT_FALSE(course_.isDue(3.0, now_));
    EXPECT_TRUE(course_.isDue(4.0, now_));
    course_.showed(4.0, 0.0, now_);
    EXPECT_TRUE(course_.isDue(5.0, now_ + FilterCourse::kNewsInterval));
    course_.begin(8, false);
    course_.doWithoutFilter(4);
    EXPECT_FALSE(course_.isDue(7.0, now_)) << "no sooner than without being told";
}

}  // namespace
}  // namespace macula::live
