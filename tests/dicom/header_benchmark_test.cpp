#include "dicom/header_benchmark.h"

#include "support.h"

namespace macula::dicom::test {
namespace {

// The requirement is 0.9 of DCMTK alone; 5 to 8 times as fast is what is reached. Many rounds, of which the
// fastest counts: one takes a few milliseconds, and the machine may be busy.
TEST(HeaderBenchmark, noSlowerThanDcmtkAlone) {
    SKIP_WITHOUT_SHARED_DATA();
    for (const char* name : {"ct_chest_ricord", "ct_cta_rider"}) {
        Progress progress;
        const auto result = benchmarkHeaders(sharedData() / name, 2, 20, progress);
        ASSERT_TRUE(result);
        EXPECT_GE(result->files, 95u);
        EXPECT_GT(result->headersPerSecond, result->bareDcmtkPerSecond) << name;
        EXPECT_GT(result->scanPerSecond, 0.0);
        std::printf("%s: %.0f headers/s, DCMTK alone %.0f, scan %.0f\n", name, result->headersPerSecond,
                    result->bareDcmtkPerSecond, result->scanPerSecond);
    }
}

TEST(HeaderBenchmark, canFailAndBeCancelled) {
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
}  // namespace macula::dicom::test
