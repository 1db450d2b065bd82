// Which series is meant by what was typed.
#include "app/study/study_input.h"

#include <gtest/gtest.h>

#include "support.h"

namespace macula::app {
namespace {

using namespace dicom::test;

class StudyInputTest : public testing::Test {
  protected:
    void SetUp() override {
        write(smallVolume(), folder_ / "a");
        write(smallVolume(glm::dmat4(1.0), {}, "MR"), folder_ / "b");
        scan_ = scan(folder_.path());
        ASSERT_TRUE(scan_);
        for (const dicom::Study& study : scan_->studies) {
            for (const dicom::Series& series : study.series) inOrder_.push_back(&series);
        }
        ASSERT_EQ(inOrder_.size(), 2u);
    }

    TemporaryFolder folder_;
    std::optional<dicom::Scan> scan_;
    std::vector<const dicom::Series*> inOrder_;  // as macula info lists them
};

TEST_F(StudyInputTest, IsMeantByItsPlaceOrItsUid) {
    EXPECT_EQ(seriesMeant(*scan_, "1"), inOrder_[0]);
    EXPECT_EQ(seriesMeant(*scan_, "2"), inOrder_[1]);
    EXPECT_EQ(seriesMeant(*scan_, "2.1"), inOrder_[1]);
    EXPECT_EQ(seriesMeant(*scan_, inOrder_[1]->seriesInstanceUid), inOrder_[1]);
    for (const char* nothing : {"0", "3", "", "-1", "2.x", "1e0", "9.9.9"})
        EXPECT_EQ(seriesMeant(*scan_, nothing), nullptr) << nothing;
}

TEST_F(StudyInputTest, IsChosenWithItsStack) {
    const auto chosen = chooseVolume(*scan_, "2.1");
    ASSERT_TRUE(chosen) << chosen.error().message;
    EXPECT_EQ(chosen->series, inOrder_[1]);
    EXPECT_EQ(chosen->stack, &inOrder_[1]->stacks.front());
    for (const char* nothing : {"3", "2.2", "2.x"}) {
        const auto refused = chooseVolume(*scan_, nothing);
        ASSERT_FALSE(refused) << nothing;
        EXPECT_EQ(refused.error().code, ErrorCode::usage) << nothing;
    }
}

// Nothing typed is the phantom, and says so; its name does not need to.
TEST(StudyInput, WithoutAPathIsThePhantom) {
    Progress progress;
    const auto unsaid = loadStudy("", "", progress);
    ASSERT_TRUE(unsaid);
    EXPECT_EQ(unsaid->notes.size(), 1u);
    const auto said = loadStudy("phantom:", "", progress);
    ASSERT_TRUE(said);
    EXPECT_TRUE(said->notes.empty());
    EXPECT_EQ(said->seriesDigest, "phantom");
    EXPECT_EQ(loadStudy("phantom:", "2", progress).error().code, ErrorCode::usage);
}

}  // namespace
}  // namespace macula::app
