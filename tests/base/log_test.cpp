// Who has the log.
#include "base/log.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace macula {
namespace {

using Lines = std::vector<std::pair<log::Level, std::string>>;

class LogTest : public ::testing::Test {
  protected:
    void SetUp() override { log::setLevel(log::Level::warning); }
    void TearDown() override { log::setSink({}); }

    static std::string printed(const std::function<void()>& what) {
        ::testing::internal::CaptureStderr();
        what();
        return ::testing::internal::GetCapturedStderr();
    }
};

TEST_F(LogTest, ASinkHasTheLinesOfItsLevelAndStderrHasNone) {
    Lines lines;
    log::setSink([&](log::Level level, std::string_view line) { lines.emplace_back(level, line); });
    EXPECT_TRUE(log::hasSink());
    EXPECT_EQ(printed([] {
                  log::info("not told");
                  log::warning("{} are told", "warnings");
                  log::error("and errors");
                  log::announce("what everybody must know");
              }),
              "");
    const Lines expected{{log::Level::warning, "warnings are told"},
                         {log::Level::error, "and errors"},
                         {log::Level::info, "what everybody must know"}};
    EXPECT_EQ(lines, expected);
}

TEST_F(LogTest, WithoutASinkStderrHasThem) {
    EXPECT_FALSE(log::hasSink());
    EXPECT_NE(printed([] { log::warning("a warning"); }).find("a warning"), std::string::npos);
    EXPECT_EQ(printed([] { log::announce("Macula renders on something"); }), "Macula renders on something\n");
}

TEST_F(LogTest, TwoThreadsAreNotHeardAtOnce) {
    int inside = 0;
    int heard = 0;
    bool wasAlone = true;
    log::setSink([&](log::Level, std::string_view) {
        wasAlone = wasAlone && ++inside == 1;
        ++heard;
        --inside;
    });
    const auto tell = [] {
        for (int i = 0; i < 500; ++i) log::warning("line {}", i);
    };
    std::thread other(tell);
    tell();
    other.join();
    EXPECT_TRUE(wasAlone);
    EXPECT_EQ(heard, 1000);
}

// After all that is static was destroyed, a thread of a host may still be at work. Not of the fixture: what
// is logged first here comes after what is to be done last.
TEST(LogDeathTest, GoesOnUntilTheVeryEnd) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    static std::string before;  // in a new process, which runs this alone
    const auto logAndEnd = [] {
        std::atexit([] {
            log::error("at the end it is {}", log::redact("a name") == before ? "the same" : "another");
        });
        before = log::redact("a name");
        log::setLevel(log::Level::warning);
        std::exit(0);
    };
    EXPECT_EXIT(logAndEnd(), ::testing::ExitedWithCode(0), "at the end it is the same");
}

}  // namespace
}  // namespace macula
