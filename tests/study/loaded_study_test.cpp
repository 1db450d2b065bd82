// Which series is meant by what was typed.
#include "study/open/loaded_study.h"

#include <gtest/gtest.h>

#include <fstream>

#include "support.h"
#include "synthetic.h"

namespace macula::study {
namespace {

using namespace dicom::test;

class LoadedStudyTest : public testing::Test {
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

TEST_F(LoadedStudyTest, IsMeantByItsPlaceOrItsUid) {
    EXPECT_EQ(seriesMeant(*scan_, "1"), inOrder_[0]);
    EXPECT_EQ(seriesMeant(*scan_, "2"), inOrder_[1]);
    EXPECT_EQ(seriesMeant(*scan_, "2.1"), inOrder_[1]);
    EXPECT_EQ(seriesMeant(*scan_, inOrder_[1]->seriesInstanceUid), inOrder_[1]);
    for (const char* nothing : {"0", "3", "", "-1", "2.x", "1e0", "9.9.9"})
        EXPECT_EQ(seriesMeant(*scan_, nothing), nullptr) << nothing;
}

TEST_F(LoadedStudyTest, IsChosenWithItsStack) {
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

TEST_F(LoadedStudyTest, OneFileThatIsLeftOutIsNotToldAsSeveral) {
    const auto noteOf = [&] {
        Progress progress;
        const auto input = loadStudy(folder_.path(), "1", progress);
        EXPECT_TRUE(input);
        for (const Text& note : input ? input->notes : std::vector<Text>())
            if (note.english().find("left out; macula info") != std::string::npos) return note.english();
        return std::string();
    };
    const auto writeDamaged = [&](const char* name) {
        std::ofstream(folder_ / name, std::ios::binary)
            << std::string(128, '\0') << "DICM" << std::string(400, '\x7F');
    };
    EXPECT_EQ(noteOf(), "");
    writeDamaged("one");
    EXPECT_EQ(noteOf(), "1 file was left out; macula info says why.");
    writeDamaged("two");
    EXPECT_EQ(noteOf(), "2 files were left out; macula info says why.");
}

// That of several patients, or nothing.
std::string warningOf(const LoadedStudy& input) {
    for (const Text& warning : input.warnings)
        if (warning.english().find("patients") != std::string::npos) return warning.english();
    return {};
}

TEST(LoadedStudy, OfOneOfSeveralPatientsIsAWarningUnlessTheSeriesWasChosen) {
    const TemporaryFolder folder;
    SyntheticSeries series;
    writeFiles(folder / "a", series);
    Progress progress;
    const auto one = loadStudy(folder.path(), "", progress);
    ASSERT_TRUE(one) << one.error().message;
    EXPECT_EQ(warningOf(*one), "");
    series.patientId = "SYN2";
    series.patientName = "SYNTHETIC^TWO";
    series.studyUid = "2.25.1100";
    series.seriesUid = "2.25.1101";
    writeFiles(folder / "b", series);
    const auto either = loadStudy(folder.path(), "", progress);
    ASSERT_TRUE(either) << either.error().message;
    EXPECT_NE(warningOf(*either).find("of 2 patients in this folder"), std::string::npos);
    EXPECT_NE(warningOf(*either).find("macula info"), std::string::npos);
    EXPECT_EQ(either->notes.front(), warningOf(*either)) << "told once";
    const auto numbered = loadStudy(folder.path(), "", progress, 1);
    ASSERT_TRUE(numbered) << numbered.error().message;
    EXPECT_NE(warningOf(*numbered).find("of 2 patients"), std::string::npos);
    const auto chosen = loadStudy(folder.path(), "2", progress);
    ASSERT_TRUE(chosen) << chosen.error().message;
    EXPECT_EQ(warningOf(*chosen), "");
}

// Nothing typed is the phantom, and says so; its name does not need to.
TEST(LoadedStudy, WithoutAPathIsThePhantom) {
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
}  // namespace macula::study
