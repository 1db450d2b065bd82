#include "evaluate/store_benchmark.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace macula::evaluate {
namespace {

namespace fs = std::filesystem;

class StoreBenchmarks : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "macula-store-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder_ = name;
    }
    void TearDown() override { fs::remove_all(folder_); }

    static StoreBenchmarkOptions small() {
        return {.studies = 6, .seriesPerStudy = 2, .models = 8, .modelBytes = 100, .repetitions = 2};
    }

    fs::path folder_;
};

TEST_F(StoreBenchmarks, TellWhatTheStoreListsAndThatItsCapHolds) {
    Progress progress;
    const auto measured = measureStore(folder_ / "store", small(), progress);
    ASSERT_TRUE(measured.ok()) << measured.error().message;
    EXPECT_EQ(measured->studies, 6u);
    EXPECT_EQ(measured->series, 12u);
    EXPECT_EQ(measured->models, 8u);
    EXPECT_EQ(measured->modelBytes, 800u);
    EXPECT_EQ(measured->evictedModels, 4u);
    EXPECT_EQ(measured->capBytes, 400u);
    EXPECT_EQ(measured->bytesLeft, 400u);
    EXPECT_EQ(measured->fileBytesLeft, 400u);
    EXPECT_TRUE(measured->capHolds());
    EXPECT_GT(measured->makeSeconds, 0.0);
    EXPECT_TRUE(fs::exists(folder_ / "store" / "sessions.db")) << "wherever it was made";
}

TEST_F(StoreBenchmarks, ACapThatDoesNotHoldIsSeenInRowsAndInFiles) {
    EXPECT_TRUE((StoreBenchmark{.capBytes = 400, .bytesLeft = 400, .fileBytesLeft = 400}).capHolds());
    EXPECT_FALSE((StoreBenchmark{.capBytes = 400, .bytesLeft = 401, .fileBytesLeft = 400}).capHolds());
    EXPECT_FALSE((StoreBenchmark{.capBytes = 400, .bytesLeft = 400, .fileBytesLeft = 401}).capHolds());
}

TEST_F(StoreBenchmarks, CanBeStopped) {
    const CancelToken token;
    Progress progress({}, token);
    token.cancel();
    const auto measured = measureStore(folder_ / "store", small(), progress);
    ASSERT_FALSE(measured.ok());
    EXPECT_EQ(measured.error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace macula::evaluate
