#include "evaluate/load_benchmark.h"

#include <filesystem>
#include <fstream>

#include "support.h"

namespace macula::evaluate {
namespace {

using namespace dicom::test;

// What it measures, and of how many files; how fast is for `macula-bench load` to say.
TEST(HeaderBenchmark, CountsTheHeadersOfAllFiles) {
    const TemporaryFolder folder;
    write(smallVolume(), folder.path());
    const auto files = std::distance(std::filesystem::directory_iterator(folder.path()),
                                     std::filesystem::directory_iterator());
    std::ofstream(folder.path() / "notes.txt") << "no DICOM";
    Progress progress;
    const auto result = benchmarkHeaders(folder.path(), 2, 3, progress);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(result->files, std::size_t(files));
    EXPECT_GT(result->headersPerSecond, 0.0);
    EXPECT_GT(result->bareDcmtkPerSecond, 0.0);
    EXPECT_GT(result->scanPerSecond, 0.0);
}

TEST(HeaderBenchmark, CanFailAndBeCancelled) {
    Progress progress;
    EXPECT_FALSE(benchmarkHeaders("/nowhere", 2, 1, progress));
    const TemporaryFolder folder;
    write(smallVolume(), folder.path());
    const CancelToken token;
    token.cancel();
    Progress cancelled({}, token);
    const auto result = benchmarkHeaders(folder.path(), 2, 1, cancelled);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace macula::evaluate
