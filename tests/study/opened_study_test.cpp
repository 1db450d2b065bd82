#include "study/open/opened_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "base/atomic_file.h"
#include "base/paths.h"
#include "base/phantom.h"
#include "dicom/support.h"
#include "dicom/synthetic.h"
#include "dicom/synthetic_pet.h"
#include "formats/volume_file.h"
#include "pipeline/volume/window.h"
#include "scene/slices/measurements_file.h"
#include "slices/measurement.h"
#include "slices/sampled_slice.h"
#include "study/open/found_volumes.h"
#include "study/open/loaded_study.h"

namespace macula::study {
namespace {

TEST(OpenStudy, GivesUpWhereverItIsCancelled) {
    const std::filesystem::path folder = macula::test::sharedFolder() / "data/ct_cta_rider";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "shared data is not here";
    // At the first word of each stage of the work: what is left of it must not be done.
    for (const char* stage : {"Reading", "Decoding"}) {
        const CancelToken token;
        bool reached = false;
        Progress progress(
            [&](const ProgressUpdate& update) {
                if (update.stage.english().find(stage) == std::string::npos) return;
                reached = true;
                token.cancel();
            },
            token);
        const auto study = openStudy(folder, progress);
        EXPECT_TRUE(reached) << stage;
        ASSERT_FALSE(study.ok()) << stage;
        EXPECT_EQ(study.error().code, ErrorCode::cancelled) << stage;
    }
}

// Some things are said of a series, of its stack and of its volume.
TEST(OpenStudy, TellsNothingTwice) {
    const std::filesystem::path folder = macula::test::sharedFolder() / "data/odd/dicomdir_media";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "shared data is not here";
    Progress progress;
    const auto study = openStudy(folder, progress);
    ASSERT_TRUE(study.ok()) << study.error().message;
    std::vector<std::string> messages;
    for (const Text& message : study->messages) messages.push_back(message.english());
    EXPECT_FALSE(messages.empty());
    std::ranges::sort(messages);
    EXPECT_EQ(std::ranges::adjacent_find(messages), messages.end());
}

// Two patients in one folder: the best series is the CT, but who opens a file of the other one means that.
class FileInAFolderOfTwo : public testing::Test {
  protected:
    void SetUp() override {
        root_ = folder_.path();
        const std::filesystem::path data = macula::test::sharedFolder() / "data";
        if (!std::filesystem::exists(data)) GTEST_SKIP() << "shared data is not here";
        for (const char* name : {"ct_cta_rider", "mr_head_sag_hfs"}) {
            int index = 0;
            for (const auto& entry : std::filesystem::recursive_directory_iterator(data / name)) {
                if (!entry.is_regular_file()) continue;
                std::string copy = name;
                copy += std::to_string(index++);
                std::filesystem::copy_file(entry.path(), root_ / copy);
            }
        }
    }
    static std::string modalityOf(const std::filesystem::path& source) {
        Progress progress;
        const auto study = openStudy(source, progress);
        return study ? study->volume->modality() : study.error().message.english();
    }

    dicom::test::TemporaryFolder folder_;
    std::filesystem::path root_;
};

TEST_F(FileInAFolderOfTwo, ItsOwnSeriesIsOpened) {
    EXPECT_EQ(modalityOf(root_), "CT");
    EXPECT_EQ(modalityOf(root_ / "mr_head_sag_hfs0"), "MR");
    EXPECT_EQ(modalityOf(root_ / "ct_cta_rider0"), "CT");
    Progress progress;
    const auto study = openStudy(root_ / "mr_head_sag_hfs0", progress);
    ASSERT_TRUE(study.ok());
    EXPECT_FALSE(study->whyThisSeries.empty());
}

TEST_F(FileInAFolderOfTwo, ARelativeNameWithoutAFolderWorks) {
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(root_);
    const std::string modality = modalityOf("mr_head_sag_hfs0");
    std::filesystem::current_path(before);
    EXPECT_EQ(modality, "MR");
}

TEST_F(FileInAFolderOfTwo, AFileThatIsNoImageOpensNothing) {
    std::ofstream(root_ / "notes.txt") << "not DICOM";
    Progress progress;
    const auto study = openStudy(root_ / "notes.txt", progress);
    ASSERT_FALSE(study.ok());
    EXPECT_EQ(study.error().code, ErrorCode::inputNotUsable);
    EXPECT_FALSE(study.error().hint.empty());
}

// Three series, the best of which cannot be decoded, which the headers do not tell.
class FolderWithADamagedSeries : public testing::Test {
  protected:
    void SetUp() override {
        best_ = write("2.25.1", "ONE^A", 3, 30);
        next_ = write("2.25.1", "ONE^A", 4, 8);
        write("2.25.2", "TWO^B", 5, 24);
        damage(best_);
    }
    std::vector<std::filesystem::path> write(const std::string& study, const std::string& patient, int number,
                                             int slices) {
        dicom::test::SyntheticSeries series;
        series.studyUid = study;
        series.seriesUid = study + "." + std::to_string(number);
        series.frameOfReferenceUid = series.seriesUid + ".1";
        series.patientName = patient;
        series.patientId = patient;
        series.number = number;
        series.size.z = slices;
        series.transferSyntaxUid = "1.2.840.10008.1.2.5";
        std::vector<dicom::test::Slice> all = dicom::test::slicesOf(series);
        for (std::size_t k = 0; k < all.size(); ++k)
            all[k].sopInstanceUid = series.seriesUid + ".2." + std::to_string(k);
        const std::filesystem::path folder = folder_ / std::to_string(number);
        std::filesystem::create_directories(folder);
        return dicom::test::writeFiles(folder, series, all);
    }
    // Where the first of two RLE segments begins, at 64, becomes a place outside of the file.
    static void damage(const std::vector<std::filesystem::path>& files) {
        for (const auto& file : files) {
            std::string bytes = readText(file).value();
            const std::size_t header = bytes.find(std::string("\2\0\0\0\x40\0\0\0", 8));
            ASSERT_NE(header, std::string::npos);
            bytes.replace(header + 4, 4, "\x7F\x7F\x7F\x7F");
            std::ofstream(file, std::ios::binary) << bytes;
        }
    }
    Result<OpenedStudy> open() const {
        Progress progress;
        return openStudy(folder_.path(), progress);
    }

    dicom::test::TemporaryFolder folder_;
    std::vector<std::filesystem::path> best_;
    std::vector<std::filesystem::path> next_;
};

TEST_F(FolderWithADamagedSeries, TheNextBestOfThatPatientIsShownAndWhatIsNotIsSaid) {
    const auto study = open();
    ASSERT_TRUE(study.ok()) << study.error().message;
    EXPECT_EQ(study->volume->size().z, 8) << "and not the larger one of another patient";
    EXPECT_EQ(study->identity.patientName, "ONE^A");
    ASSERT_GE(study->messages.size(), 2u);
    EXPECT_EQ(study->messages[0].english().find(
                  "Series 3 (30 images) could not be opened: 30 of the 30 images cannot be "
                  "decoded."),
              0u)
        << study->messages[0];
    EXPECT_EQ(study->messages[1], "The best of the other volumes is shown instead.");
    EXPECT_EQ(study->whyThisSeries, "The best volume that can be opened.");
    EXPECT_EQ(study->found->volumes().at(study->volumeIndex).series->number, 4);
}

TEST_F(FolderWithADamagedSeries, AnotherPatientIsShownOnlyWhereNothingElseCanBeAndThatIsSaid) {
    damage(next_);
    const auto study = open();
    ASSERT_TRUE(study.ok()) << study.error().message;
    EXPECT_EQ(study->identity.patientName, "TWO^B");
    ASSERT_GE(study->messages.size(), 3u);
    EXPECT_EQ(study->messages[1].english().find("Series 4 (8 images) could not be opened: "), 0u);
    EXPECT_EQ(study->messages[2],
              "The best of the other volumes is shown instead, which is of another patient.");
}

TEST_F(FolderWithADamagedSeries, WhereASeriesWasAskedForNoOtherTakesItsPlace) {
    Progress progress;
    const auto ofFile = openStudy(best_.front(), progress);
    ASSERT_FALSE(ofFile.ok());
    EXPECT_NE(ofFile.error().message.english().find("cannot be decoded"), std::string::npos);
    EXPECT_FALSE(openStudy(folder_.path(), progress, {.series = "2.25.1.3"}).ok());
    const auto study = open();
    ASSERT_TRUE(study.ok());
    const auto& volumes = study->found->volumes();
    for (std::size_t index = 0; index < volumes.size(); ++index)
        EXPECT_EQ(openFoundVolume(study->found, index, progress).ok(), volumes[index].series->number != 3);
}

TEST(OpenStudy, OpensAVolumeFileAndNamesNobody) {
    const std::filesystem::path file =
        macula::test::sharedFolder() / "data/odd/mixed_flat_folder_truth_mr.nii.gz";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "shared data is not here";
    Progress progress;
    const auto study = openStudy(file, progress);
    ASSERT_TRUE(study.ok()) << study.error().message;
    EXPECT_EQ(study->volume->size(), glm::ivec3(115, 90, 35));
    EXPECT_EQ(study->identity.series, "File mixed_flat_folder_truth_mr.nii.gz");
    EXPECT_TRUE(study->identity.patientName.empty());
    EXPECT_FALSE(study->identity.isOfNobody);
    EXPECT_TRUE(study->volumeTitles.empty());
}

TEST(OpenStudy, ADicomdirStandsForItsFolder) {
    const std::filesystem::path folder = macula::test::sharedFolder() / "data/odd/dicomdir_media";
    if (!std::filesystem::exists(folder / "DICOMDIR")) GTEST_SKIP() << "shared data is not here";
    Progress progress;
    const auto ofFolder = openStudy(folder, progress);
    const auto ofFile = openStudy(folder / "DICOMDIR", progress);
    ASSERT_EQ(ofFile.ok(), ofFolder.ok());
    if (ofFile.ok()) {
        EXPECT_EQ(ofFile->identity, ofFolder->identity);
        EXPECT_EQ(ofFile->volumeTitles, ofFolder->volumeTitles);
    } else {
        EXPECT_EQ(ofFile.error().message, ofFolder.error().message);
    }
}

TEST_F(FileInAFolderOfTwo, EachVolumeIsListedWithItsPatient) {
    Progress progress;
    const auto study = openStudy(root_, progress);
    ASSERT_TRUE(study.ok());
    ASSERT_EQ(study->volumeTitles.size(), 2u);
    EXPECT_FALSE(study->volumeTitles[0] == study->volumeTitles[1]);
    for (std::size_t i = 0; i < 2; ++i) {
        const auto other = openFoundVolume(study->found, i, progress);
        ASSERT_TRUE(other.ok());
        EXPECT_EQ(other->volumeIndex, i);
        std::vector<std::string> lines;
        for (const Text& line : linesOf(other->identity)) lines.push_back(line.english());
        EXPECT_NE(study->volumeTitles[i].english().find(lines[0]), std::string::npos)
            << study->volumeTitles[i];
        EXPECT_NE(study->volumeTitles[i].english().find(lines[3]), std::string::npos)
            << study->volumeTitles[i];
        EXPECT_EQ(other->volume->modality(), lines[3].substr(0, 2));
    }
}

// An ADC map, of whole and half numbers, in which one division went wrong. In 16 bits over all of its range
// it would have steps of 15.
TEST(OpenStudy, MeasuresWhatTheFileHas) {
    constexpr int kSide = 40;
    std::vector<float> voxels(std::size_t{kSide} * kSide * kSide);
    for (std::size_t n = 0; n < voxels.size(); ++n)
        voxels[n] = n % kSide < 20 ? 800.5F : 1400.0F + 0.25F * float(n % 3);
    voxels.back() = 1e6F;
    const auto made = Volume::createFloat({.size = glm::ivec3(kSide)}, std::move(voxels));
    const dicom::test::TemporaryFolder folder;
    Progress progress;
    ASSERT_TRUE(formats::writeVolumeFile(*made, folder / "adc.nii", progress).ok());
    const auto study = openStudy(folder / "adc.nii", progress);
    ASSERT_TRUE(study.ok()) << study.error().message;
    ASSERT_NE(study->inFloats, nullptr);
    EXPECT_EQ(study->volume->format(), VoxelFormat::stored16);

    slices::Ellipse ellipse{.radiiMm = {6.0, 6.0}};
    ellipse.plane.centreMm = transformPoint(study->measured()->worldFromVoxel(), {10.0, 20.0, 20.0});
    const auto values = slices::valuesIn(ellipse, *study->measured());
    ASSERT_TRUE(values);
    EXPECT_DOUBLE_EQ(values->mean, 800.5);
    EXPECT_DOUBLE_EQ(values->deviation, 0.0);
    const std::string csv =
        scene::measurementsCsv(std::vector<slices::Measurement>{{.shape = ellipse}}, *study->measured());
    EXPECT_NE(csv.find(",800.5,0,800.5,800.5,"), std::string::npos) << csv;
    const slices::SampledSlice slice =
        slices::sampleSlice(*study->measured(), {.plane = ellipse.plane, .mmPerPixel = 1.0, .sizePx = {3, 3}},
                            {}, slices::Filter::linear);
    for (const float value : slice.values) EXPECT_EQ(value, 800.5F);
    // Even what is drawn keeps its steps.
    EXPECT_NEAR(study->volume->value(10, 20, 20), 800.5, 0.05);
}

TEST(OpenStudy, KeepsOneCopyOfVoxelsThat16BitsHold) {
    const auto made = Volume::createFloat({.size = glm::ivec3(2)}, {-7, 0, 5, 600, 1, 2, 3, 4});
    const dicom::test::TemporaryFolder folder;
    Progress progress;
    ASSERT_TRUE(formats::writeVolumeFile(*made, folder / "whole.nii", progress).ok());
    const auto study = openStudy(folder / "whole.nii", progress);
    ASSERT_TRUE(study.ok());
    EXPECT_EQ(study->inFloats, nullptr);
    EXPECT_EQ(study->measured(), study->volume);
}

TEST(OpenStudy, PetIsInSuvWithLowValuesWhiteAndAWindowUpToTen) {
    for (const bool hasDose : {true, false}) {
        const dicom::test::TemporaryFolder folder;
        writeFiles(folder.path(), dicom::test::petSeries(hasDose));
        Progress progress;
        const auto study = openStudy(folder.path(), progress);
        ASSERT_TRUE(study.ok()) << study.error().message;
        EXPECT_TRUE(study->isLowBright);
        const Volume& volume = *study->measured();
        EXPECT_EQ(volume.unitName(), hasDose ? "SUV bw" : "Bq/mL");
        const DisplayWindow window = seriesWindow(volume);
        const double high = window.center + 0.5 * window.width;
        EXPECT_DOUBLE_EQ(window.center, 0.5 * window.width) << "from 0";
        if (hasDose) {
            EXPECT_DOUBLE_EQ(high, std::min(10.0, volume.valueRange()->high));
        } else {
            EXPECT_GT(high, 0.5 * volume.valueRange()->high);
            EXPECT_LE(high, volume.valueRange()->high);
        }
    }
}

// What others read has to be what the images say; what is drawn is as in the window.
TEST(LoadStudy, ExportsHaveTheUnitOfTheImages) {
    const dicom::test::TemporaryFolder folder;
    writeFiles(folder.path(), dicom::test::petSeries());
    Progress progress;
    const auto drawn = loadStudy(folder.path(), {}, progress);
    const auto exported = loadStudy(folder.path(), {}, progress, 0, {}, PetUnit::asInImages);
    ASSERT_TRUE(drawn.ok() && exported.ok());
    EXPECT_EQ(drawn->volume->unit(), Unit::suvBodyWeight);
    EXPECT_EQ(exported->volume->unit(), Unit::becquerelsPerMillilitre);
    EXPECT_NEAR(drawn->volume->valueRange()->high,
                exported->volume->valueRange()->high * dicom::test::kSuvPerBqPerMl, 1e-6);
}

}  // namespace
}  // namespace macula::study
