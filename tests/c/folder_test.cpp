// What the C interface tells of a folder: which volume was taken, of whom, and what was left out.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcdeftag.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "c/c_fixture.h"
#include "dicom/support.h"
#include "dicom/synthetic.h"

namespace macula::test {
namespace {

using Json = nlohmann::json;

Owned<macula_study> open(const std::filesystem::path& path, const char* series = nullptr) {
    auto how = sized<macula_open>();
    how.series_uid = series;
    macula_study* made = nullptr;
    EXPECT_EQ(macula_study_open(path.c_str(), &how, nullptr, &made), MACULA_DONE) << lastError().message;
    return Owned<macula_study>(made);
}

Json foundIn(const Owned<macula_study>& study) {
    const char* text = nullptr;
    EXPECT_EQ(macula_study_found(study.get(), &text), MACULA_DONE) << lastError().message;
    return text == nullptr ? Json() : Json::parse(text);
}

bool isSaid(const Owned<macula_study>& study, const std::string& words) {
    return std::ranges::any_of(
        notesOf(study.get()), [&](const std::string& note) { return note.find(words) != std::string::npos; });
}

// Two patients of a series each, and a file that was cut off.
class CFolder : public ::testing::Test {
  protected:
    void SetUp() override {
        dicom::test::SyntheticSeries one;
        dicom::test::SyntheticSeries other;
        other.patientId = "SYN2";
        other.patientName = "SYNTHETIC^TWO";
        other.studyUid = "2.25.1100";
        other.seriesUid = "2.25.1101";
        other.frameOfReferenceUid = "2.25.1102";
        other.size = {8, 7, 30};
        writeFiles(folder_ / "one", one);
        const auto files = writeFiles(folder_ / "other", other);
        std::filesystem::copy_file(files.front(), folder_ / "cut");
        std::filesystem::resize_file(folder_ / "cut", 200);
    }

    dicom::test::TemporaryFolder folder_;
};

// Which of both is shown is for the host to say, and not for the number of voxels.
TEST_F(CFolder, OfSeveralPatientsWithoutAChoiceIsAnErrorWithTheChoice) {
    macula_study* made = nullptr;
    const std::string path = folder_.path().string();
    expectError(macula_study_open(path.c_str(), nullptr, nullptr, &made), MACULA_INPUT);
    EXPECT_EQ(made, nullptr);
    const std::string message = lastError().message;
    const std::string advice = lastError().advice;
    EXPECT_NE(message.find("of 2 patients"), std::string::npos) << message;
    EXPECT_NE(message.find("patient 1 has series 1 (CT, 12 images); patient 2 has series 2 (CT, 30 images)"),
              std::string::npos)
        << message;
    EXPECT_NE(advice.find("series_uid"), std::string::npos) << advice;
    EXPECT_EQ((message + advice).find("SYN"), std::string::npos) << "sentences name nobody";
    // The answer, by that number.
    auto how = sized<macula_open>();
    for (const auto& [number, uid] : {std::pair("1", "2.25.1001"), {"2", "2.25.1101"}}) {
        how.series_uid = number;
        ASSERT_EQ(macula_study_open(path.c_str(), &how, nullptr, &made), MACULA_DONE) << lastError().message;
        const Owned<macula_study> study(made);
        auto volume = sized<macula_volume>();
        ASSERT_EQ(macula_study_volume(made, &volume), MACULA_DONE);
        EXPECT_STREQ(volume.series_uid, uid);
    }
    how.series_uid = "3";
    expectError(macula_study_open(path.c_str(), &how, nullptr, &made), MACULA_INPUT);
    // An image is a choice, and so is a folder of one patient.
    made = nullptr;
    EXPECT_EQ(macula_study_open((folder_ / "other").c_str(), nullptr, nullptr, &made), MACULA_DONE);
    macula_study_close(made);
}

// A program has written the same name for both.
TEST_F(CFolder, TwoStudiesOfNobodyMayBeOfTwoPatients) {
    const dicom::test::TemporaryFolder own;
    for (const char* study : {"2.25.1000", "2.25.1100"}) {
        dicom::test::SyntheticSeries series;
        series.patientId = "ANON";
        series.patientName = "ANONYMOUS";
        series.studyUid = study;
        series.seriesUid = study + std::string("1");
        writeFiles(own / study, series);
    }
    macula_study* made = nullptr;
    expectError(macula_study_open(own.path().c_str(), nullptr, nullptr, &made), MACULA_INPUT);
    EXPECT_NE(std::string(lastError().message).find("of up to 2 patients"), std::string::npos)
        << lastError().message;
}

TEST_F(CFolder, TheSeriesThatIsAskedForIsOpened) {
    auto how = sized<macula_open>();
    const std::string path = folder_.path().string();
    macula_study* made = nullptr;
    for (const char* uid : {"2.25.1001", "2.25.1101"}) {
        how.series_uid = uid;
        ASSERT_EQ(macula_study_open(path.c_str(), &how, nullptr, &made), MACULA_DONE) << lastError().message;
        const Owned<macula_study> study(made);
        auto volume = sized<macula_volume>();
        ASSERT_EQ(macula_study_volume(made, &volume), MACULA_DONE);
        EXPECT_STREQ(volume.series_uid, uid);
        EXPECT_FALSE(isSaid(study, "patient you mean")) << "it was chosen";
    }
    how.series_uid = "2.25.9";
    expectError(macula_study_open(path.c_str(), &how, nullptr, &made), MACULA_INPUT);
    EXPECT_EQ(made, nullptr);
    expectError(macula_study_open("phantom:", &how, nullptr, &made), MACULA_USAGE);
    // A host of before knows nothing of it, and is told.
    how.size = 8;
    expectError(macula_study_open(path.c_str(), &how, nullptr, &made), MACULA_INPUT);
}

TEST_F(CFolder, WhatWasLeftOutIsSaidWithTheReason) {
    const auto study = open(folder_.path(), "2.25.1001");
    ASSERT_NE(study, nullptr);
    EXPECT_TRUE(isSaid(study, "Left out, 1 file: "));
    const Json found = foundIn(study);
    ASSERT_EQ(found.at("skipped").size(), 1u);
    EXPECT_NE(found.at("skipped")[0].at("sentence"), "");
    EXPECT_NE(found.at("skipped")[0].at("file").get<std::string>().find("cut"), std::string::npos);
}

TEST_F(CFolder, EachVolumeHasItsPlaceAndItsIdentifiers) {
    const auto study = open(folder_.path(), "2.25.1001");
    ASSERT_NE(study, nullptr);
    const char* const title = macula_study_title(study.get(), 0);
    ASSERT_EQ(macula_study_choose(study.get(), 1, nullptr), MACULA_DONE) << lastError().message;
    EXPECT_EQ(macula_study_title(study.get(), 0), title) << "titles live as long as the study";
    const Json found = foundIn(study);
    ASSERT_EQ(found.at("volumes").size(), macula_study_volumes(study.get()));
    EXPECT_EQ(found.at("patients"), 2);
    for (std::uint32_t index = 0; index < 2; ++index) {
        ASSERT_EQ(macula_study_choose(study.get(), index, nullptr), MACULA_DONE) << lastError().message;
        auto volume = sized<macula_volume>();
        ASSERT_EQ(macula_study_volume(study.get(), &volume), MACULA_DONE);
        const bool isOther = std::string(volume.series_uid) == "2.25.1101";
        EXPECT_STREQ(volume.series_uid, isOther ? "2.25.1101" : "2.25.1001");
        EXPECT_STREQ(volume.study_uid, isOther ? "2.25.1100" : "2.25.1000");
        EXPECT_STREQ(volume.frame_of_reference_uid, isOther ? "2.25.1102" : "2.25.1002");
        EXPECT_EQ(volume.slices, isOther ? 30 : 12);
        for (const Json& of : found.at("studies"))
            for (const Json& series : of.at("series"))
                for (const Json& stack : series.at("stacks"))
                    if (stack.at("place") == found.at("volumes")[index]) {
                        EXPECT_EQ(series.at("seriesInstanceUid"), volume.series_uid);
                        EXPECT_EQ(stack.at("size")[2], volume.slices);
                        EXPECT_EQ(of.at("patientId"), isOther ? "SYN2" : "SYN1");
                    }
    }
}

TEST_F(CFolder, SaysWhetherPixelsAreCalibrated) {
    for (const bool isCalibrated : {true, false}) {
        const dicom::test::TemporaryFolder own;
        dicom::test::SyntheticSeries series;
        series.edits.push_back([&](DcmItem& item) {
            if (!isCalibrated) dicom::test::erase(item, DCM_PixelSpacing);
            dicom::test::put(item, DCM_ImagerPixelSpacing, "1.1\\0.7");
        });
        writeFiles(own.path(), series);
        const auto study = open(own.path());
        ASSERT_NE(study, nullptr);
        auto volume = sized<macula_volume>();
        ASSERT_EQ(macula_study_volume(study.get(), &volume), MACULA_DONE);
        EXPECT_EQ(volume.is_uncalibrated, isCalibrated ? 0 : 1);
        EXPECT_EQ(isSaid(study, "not calibrated"), !isCalibrated);
        const Json stack = foundIn(study).at("studies")[0].at("series")[0].at("stacks")[0];
        EXPECT_EQ(stack.at("calibrated"), isCalibrated);
    }
}

TEST(CFound, WithoutAFolderNothingIsListed) {
    const auto study = TwoBalls().study();
    const Json found = foundIn(study);
    EXPECT_TRUE(found.at("volumes").empty());
    EXPECT_TRUE(found.at("studies").empty());
    EXPECT_TRUE(found.at("skipped").empty());
    auto volume = sized<macula_volume>();
    ASSERT_EQ(macula_study_volume(study.get(), &volume), MACULA_DONE);
    EXPECT_STREQ(volume.study_uid, "");
    EXPECT_STREQ(volume.frame_of_reference_uid, "");
    expectError(macula_study_found(study.get(), nullptr), MACULA_USAGE);
    const char* text = "not touched";
    expectError(macula_study_found(nullptr, &text), MACULA_USAGE);
    EXPECT_EQ(text, nullptr);
}

}  // namespace
}  // namespace macula::test
