// Work beside the window that cannot be begun, or cannot be done.
#include "viewer/jobs/background_job.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <new>
#include <optional>

#include "base/no_threads.h"
#include "viewer/wait_until.h"

namespace macula::viewer {
namespace {

class BackgroundJobTest : public testing::Test {
  protected:
    BackgroundJobTest()
        : application_(argc_, argv_),
          job_(&home_, {.ended = [this](const Result<int>& outcome) { outcome_ = outcome; }}) {}

    void expectNoMemory() const {
        ASSERT_TRUE(outcome_ && !*outcome_);
        EXPECT_EQ(outcome_->error().code, ErrorCode::outOfMemory);
        EXPECT_FALSE(outcome_->error().message.empty());
        EXPECT_FALSE(outcome_->error().hint.empty());
        EXPECT_FALSE(job_.running());
        EXPECT_TRUE(job_.atRest());
    }

    int argc_ = 1;
    char name_[5] = "test";
    char* argv_[2] = {name_, nullptr};
    QCoreApplication application_;
    QObject home_;
    std::optional<Result<int>> outcome_;
    BackgroundJob<int> job_;
};

TEST_F(BackgroundJobTest, WithoutAThreadItEndsWithAnErrorAndTheNextOneWorks) {
    {
        const test::NoThreads none;
        bool wasBegun = false;
        job_.start([&](Progress&) -> Result<int> {
            wasBegun = true;
            return 1;
        });
        EXPECT_TRUE(job_.running());
        EXPECT_FALSE(outcome_) << "it is told in its turn";
        QCoreApplication::processEvents();
        expectNoMemory();
        EXPECT_FALSE(wasBegun) << "the thread of the window did it";
    }
    outcome_.reset();
    job_.start([](Progress&) -> Result<int> { return 2; });
    ASSERT_TRUE(waitUntil([&] { return outcome_.has_value(); }));
    ASSERT_TRUE(outcome_->ok());
    EXPECT_EQ(**outcome_, 2);
}

// Another one takes its place before that is told.
TEST_F(BackgroundJobTest, OfOneThatCouldNotBeBegunNothingIsToldOnceThereIsAnother) {
    {
        const test::NoThreads none;
        job_.start([](Progress&) -> Result<int> { return 1; });
    }
    job_.start([](Progress&) -> Result<int> { return 2; });
    ASSERT_TRUE(waitUntil([&] { return outcome_.has_value(); }));
    ASSERT_TRUE(outcome_->ok());
    EXPECT_EQ(**outcome_, 2);
    EXPECT_TRUE(waitUntil([&] { return job_.atRest(); }));
}

TEST_F(BackgroundJobTest, WorkThatFindsNoMemoryDoesNotEndTheProgram) {
    job_.start([](Progress&) -> Result<int> { throw std::bad_alloc(); });
    ASSERT_TRUE(waitUntil([&] { return outcome_.has_value(); }));
    expectNoMemory();
}

TEST_F(BackgroundJobTest, MayBeDroppedWhenItCouldNotBeBegun) {
    const test::NoThreads none;
    {
        QObject home;
        BackgroundJob<int> job(&home, {.ended = [](const Result<int>&) { FAIL(); }});
        job.start([](Progress&) -> Result<int> { return 1; });
    }
    QCoreApplication::processEvents();
}

}  // namespace
}  // namespace macula::viewer
