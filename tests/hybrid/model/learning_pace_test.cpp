// What of learning fits between two frames.
#include "pipeline/hybrid/model/learning_pace.h"

#include <gtest/gtest.h>

#include <limits>

namespace macula::hybrid {
namespace {

TEST(LearningPace, NothingThatWasNeverDoneFits) {
    const LearningPace pace;
    for (const LearningPart part : {LearningPart::step, LearningPart::show, LearningPart::ask,
                                    LearningPart::trace, LearningPart::take}) {
        EXPECT_FALSE(pace.fits(part, 1e9));
        EXPECT_FALSE(pace.expectedMs(part).has_value());
    }
}

TEST(LearningPace, SlowerIsBelievedAtOnceAndFasterByAndBy) {
    LearningPace pace;
    pace.took(LearningPart::step, 300.0);  // the first one compiles
    EXPECT_FALSE(pace.fits(LearningPart::step, 8.0));
    for (int i = 0; i < 40; ++i) pace.took(LearningPart::step, 1.0);
    EXPECT_TRUE(pace.fits(LearningPart::step, 8.0));
    pace.took(LearningPart::step, 12.0);
    EXPECT_DOUBLE_EQ(*pace.expectedMs(LearningPart::step), 12.0);
    EXPECT_FALSE(pace.fits(LearningPart::step, 12.0)) << "something has to be left";
    EXPECT_TRUE(pace.fits(LearningPart::step, 15.0));
    EXPECT_FALSE(pace.fits(LearningPart::take, 15.0)) << "another part";
}

// A step that judged as well is slow; after some frames another is tried, which shows that it was that.
TEST(LearningPace, ASlowStepIsTriedAgain) {
    LearningPace pace;
    pace.took(LearningPart::step, 12.0);
    int frames = 0;
    for (; !pace.fits(LearningPart::step, 8.0); ++frames) pace.refusedStep();
    EXPECT_GT(frames, 10);
    EXPECT_LT(frames, 60) << "less than a second of motion";
    LearningPace unknown;
    unknown.refusedStep();
    EXPECT_FALSE(unknown.expectedMs(LearningPart::step).has_value());
}

TEST(LearningPace, NonsenseIsNotLearnt) {
    LearningPace pace;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double ms : {nan, infinity, -1.0}) {
        pace.took(LearningPart::step, ms);
    }
    EXPECT_FALSE(pace.fits(LearningPart::step, 1e9));
}

}  // namespace
}  // namespace macula::hybrid
