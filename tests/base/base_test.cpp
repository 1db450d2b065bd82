#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <new>
#include <stdexcept>
#include <thread>
#include <vector>

#include "base/atomic_file.h"
#include "base/log.h"
#include "base/no_threads.h"
#include "base/parallel.h"
#include "base/progress.h"
#include "base/result.h"
#include "base/sha256.h"

namespace macula {
namespace {

Result<int> half(int n) {
    if (n % 2 != 0) return Error{ErrorCode::usage, Text("Odd."), {}, Text("Use an even number.")};
    return n / 2;
}

Result<int> quarter(int n) {
    MACULA_TRY(const int h, half(n));
    return half(h);
}

TEST(Result, TryPassesValuesAndErrorsOn) {
    EXPECT_EQ(quarter(12).value(), 3);
    EXPECT_EQ(quarter(6).error().code, ErrorCode::usage);
    EXPECT_EQ(quarter(5).error().message, "Odd.");
}

TEST(ResultDeathTest, ReadingTheValueOfAnErrorAborts) {
    EXPECT_DEATH({ [[maybe_unused]] const int n = half(3).value(); }, "check failed: ok\\(\\)");
}

TEST(CheckDeathTest, PrintsBothValues) {
    const int a = 2;
    EXPECT_DEATH(MACULA_CHECK_EQ(a, 3), "a == 3: 2 against 3");
}

TEST(Sha256, MatchesTheStandardsExample) {
    EXPECT_EQ(sha256Hex(std::string_view("abc")),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Log, SensitiveTextIsDigestedAndStable) {
    const std::string line = fmt::format("{}", log::Sensitive{"DOE^JANE"});
    EXPECT_EQ(line.find("DOE"), std::string::npos);
    EXPECT_EQ(line, fmt::format("{}", log::Sensitive{"DOE^JANE"}));
    EXPECT_NE(line, fmt::format("{}", log::Sensitive{"DOE^JOHN"}));
}

TEST(ParallelFor, VisitsEachIndexOnce) {
    std::vector<std::atomic<int>> visits(1000);
    parallelFor(visits.size(), [&](std::size_t i) { ++visits[i]; });
    for (const auto& count : visits) EXPECT_EQ(count, 1);
    parallelFor(0, [](std::size_t) { FAIL(); });
}

TEST(ParallelFor, StopsWhenCancelled) {
    const CancelToken token;
    std::atomic<int> calls{0};
    parallelFor(
        100000,
        [&](std::size_t) {
            if (++calls == 10) token.cancel();
        },
        token);
    EXPECT_LT(calls, 100);
}

// From the caller's own thread and from helpers alike, and all threads are done when it arrives.
TEST(ParallelFor, ThrowsWhatIsThrownInside) {
    struct Refused : std::runtime_error {
        using std::runtime_error::runtime_error;
    };
    for (int round = 0; round < 50; ++round) {
        std::atomic<int> calls{0};
        std::atomic<int> inside{0};
        const auto body = [&](std::size_t) {
            ++inside;
            if (++calls == 10) {
                --inside;
                throw Refused("the tenth");
            }
            std::this_thread::yield();
            --inside;
        };
        try {
            parallelFor(100000, body);
            ADD_FAILURE() << "it was swallowed";
        } catch (const Refused& refused) {
            EXPECT_STREQ(refused.what(), "the tenth");
        }
        EXPECT_EQ(inside, 0);
        EXPECT_LT(calls, 100000);
    }
    // All of them at once, and the next one works again.
    EXPECT_THROW(parallelFor(64, [](std::size_t) { throw std::bad_alloc(); }), std::bad_alloc);
    std::atomic<int> calls{0};
    parallelFor(64, [&](std::size_t) { ++calls; });
    EXPECT_EQ(calls, 64);
}

TEST(ParallelFor, IsDoneByOneThreadWhereThereAreNoMore) {
    const test::NoThreads none;
    std::vector<std::size_t> visits;
    parallelFor(100, [&](std::size_t i) { visits.push_back(i); });
    ASSERT_EQ(visits.size(), 100u);
    for (std::size_t i = 0; i < visits.size(); ++i) EXPECT_EQ(visits[i], i);
}

TEST(Progress, ReportsStartAndEndAndAtMostTenTimesASecond) {
    std::vector<double> fractions;
    Progress progress([&](const ProgressUpdate& update) { fractions.push_back(update.fraction); });
    progress.beginStage(Text("Counting"), 5000);
    for (int i = 0; i < 5000; ++i) progress.advance();
    ASSERT_GE(fractions.size(), 2u);
    EXPECT_EQ(fractions.front(), 0.0);
    EXPECT_EQ(fractions.back(), 1.0);
    EXPECT_LE(fractions.size(), 5u);  // far less than half a second has passed
}

TEST(AtomicFile, AFailedWriteLeavesNeitherFileNorTemporary) {
    const auto folder = std::filesystem::temp_directory_path() / "macula-atomic-test";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directory(folder);
    const auto failed =
        writeAtomically(folder / "a.txt", [](const std::filesystem::path& temporary) -> Result<void> {
            std::ofstream(temporary) << "half";
            return Error{ErrorCode::outputNotWritable, Text("Disk full."), {}, {}};
        });
    EXPECT_FALSE(failed.ok());
    EXPECT_TRUE(std::filesystem::is_empty(folder));
    ASSERT_TRUE(writeTextAtomically(folder / "a.txt", "whole").ok());
    EXPECT_EQ(readText(folder / "a.txt").value(), "whole");
    EXPECT_FALSE(writeTextAtomically(folder / "missing" / "a.txt", "x").ok());
    EXPECT_FALSE(readText(folder / "a.txt", 3).ok());
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace macula
