// Which volumes are phases of one thing: made by hand, and those of ../shared/data against its counts.
#include "study/open/phases.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <string>
#include <utility>

#include "formats/nifti_bytes.h"
#include "found_by_hand.h"
#include "study/open/opened_study.h"
#include "support.h"

namespace macula::study {
namespace {

dicom::Stack phase(int number, int of, std::vector<dicom::StackLabel> labels) {
    dicom::Stack stack = test::volumeOf(11);
    stack.phase = number;
    stack.phases = of;
    stack.splitBy = std::move(labels);
    return stack;
}

std::shared_ptr<const FoundVolumes> found(std::vector<dicom::Series> series) {
    dicom::Scan scan;
    scan.studies.push_back(test::studyOf(0, "DOE^JANE", "20240301", "Heart", std::move(series)));
    scan.patients = 1;
    return std::make_shared<const FoundVolumes>(std::move(scan));
}

TEST(PhasesOf, AreTheStacksOfASeriesByTheirTimes) {
    std::vector<dicom::Stack> stacks;
    for (const char* kernel : {"B30f", "B60f"})
        for (int n = 0; n < 3; ++n)
            stacks.push_back(
                phase(n, 3, {{"ConvolutionKernel", kernel}, {"TriggerTime", std::to_string(120 * n + 40)}}));
    std::swap(stacks[3], stacks[5]);  // in no order
    const auto volumes = found({test::seriesOf(1, "Heart", std::move(stacks))});
    const std::vector<Phase> soft = phasesOf(*volumes, 1);
    ASSERT_EQ(soft.size(), 3u);
    EXPECT_EQ(soft[2].volume, 2u);
    EXPECT_EQ(soft[0].label.english(), "trigger time 40 ms");
    EXPECT_EQ(soft[0].atMs, 0.0);
    EXPECT_EQ(soft[2].atMs, 240.0);
    const std::vector<Phase> sharp = phasesOf(*volumes, 4);
    ASSERT_EQ(sharp.size(), 3u);
    EXPECT_EQ(sharp[0].volume, 5u);
    EXPECT_EQ(sharp[2].volume, 3u);
}

TEST(PhasesOf, HaveNoTimesWhereTheImagesSayNone) {
    std::vector<dicom::Stack> stacks;
    for (int n = 0; n < 3; ++n)
        stacks.push_back(phase(n, 3, {{"TemporalPositionIndex", std::to_string(n + 1)}}));
    for (const Phase& each : phasesOf(*found({test::seriesOf(1, "DCE", stacks)}), 0)) EXPECT_FALSE(each.atMs);
    for (int n = 0; n < 3; ++n)
        stacks[std::size_t(n)].splitBy = {
            {"AcquisitionTime", "2024030110000" + std::to_string(n) + ".25+0100"}};
    const auto timed = phasesOf(*found({test::seriesOf(1, "DCE", stacks)}), 0);
    ASSERT_EQ(timed.size(), 3u);
    EXPECT_EQ(timed[2].atMs, 2000.0);
    stacks[1].splitBy = {{"AcquisitionTime", "20240301100000.25+0100"}};  // they do not rise
    for (const Phase& each : phasesOf(*found({test::seriesOf(1, "DCE", stacks)}), 0)) EXPECT_FALSE(each.atMs);
}

TEST(PhasesOf, SeveralSeriesDifferInANumberThatNamesAPhase) {
    const auto named = [](const std::vector<std::string>& descriptions) {
        std::vector<dicom::Series> series;
        for (const std::string& description : descriptions)
            series.push_back(test::seriesOf(int(series.size()) + 1, description, {test::volumeOf(11)}));
        return found(std::move(series));
    };
    const auto breath = named({"4D 100%", "4D 0%", "4D AVG", "4D 20%"});
    const std::vector<Phase> phases = phasesOf(*breath, 0);
    ASSERT_EQ(phases.size(), 3u);
    EXPECT_EQ(phases[0].volume, 1u);
    EXPECT_EQ(phases[1].volume, 3u);
    EXPECT_EQ(phases[2].volume, 0u) << "100 is after 20";
    EXPECT_EQ(phases[1].label.english(), "4D 20%");
    EXPECT_TRUE(phasesOf(*breath, 2).empty()) << "the average is none of them";
    EXPECT_TRUE(phasesOf(*named({"Thorax 1", "Thorax 2", "Thorax 3"}), 0).empty());
    EXPECT_TRUE(phasesOf(*named({"4D 0%", "4D 50%"}), 0).empty()) << "two may differ in anything";
    EXPECT_TRUE(phasesOf(*named({"4D 0%", "4D 50%", "4D 50%"}), 0).empty());
    EXPECT_TRUE(phasesOf(*named({"", "4D 99999999999999999999%"}), 1).empty());
    EXPECT_TRUE(phasesOf(*breath, 99).empty());
}

TEST(PhasesOf, AnotherGridIsNoPhase) {
    std::vector<dicom::Stack> stacks;
    for (int n = 0; n < 3; ++n) stacks.push_back(phase(n, 3, {{"TriggerTime", std::to_string(n)}}));
    (*stacks[1].worldFromVoxel)[3].x = 5.0;
    const auto phases = phasesOf(*found({test::seriesOf(1, "Heart", std::move(stacks))}), 0);
    ASSERT_EQ(phases.size(), 2u);
    EXPECT_EQ(phases[1].volume, 2u);
}

// A NIfTI file of three times, 2.5 s apart, whose values are 100 times the number of the volume.
std::filesystem::path writeTimes(const std::filesystem::path& path, int count) {
    formats::test::NiftiBytes file = formats::test::makeNifti(4, 2);
    file.set<std::int16_t>(40, 4);
    file.set<std::int16_t>(48, std::int16_t(count));
    file.set(92, 2.5f);
    file.bytes[123] = char(2 | 8);
    file.bytes.resize(352 + std::size_t(count) * 120);
    for (int n = 0; n < count * 60; ++n)
        file.set<std::int16_t>(352 + 2 * std::size_t(n), std::int16_t(100 * (n / 60) + 1));
    formats::test::writeBytes(path, file.bytes);
    return path;
}

TEST(PhasesOf, AreTheVolumesOfAFile) {
    const dicom::test::TemporaryFolder folder;
    const std::filesystem::path path = writeTimes(folder / "times.nii", 3);
    Progress progress;
    const auto study = openStudy(path, progress);
    ASSERT_TRUE(study) << study.error().message;
    EXPECT_EQ(study->measured()->value(0, 0, 0), 1.0);
    const std::vector<Phase> phases = phasesOf(*study);
    ASSERT_EQ(phases.size(), 3u);
    EXPECT_EQ(phases[0].label.english(), "time 0 ms");
    EXPECT_EQ(phases[2].label.english(), "time 5000 ms");
    EXPECT_EQ(phases[2].atMs, 5000.0);
    const PhaseSource source = phaseSourceOf(*study);
    for (const Phase& each : phases) {
        const auto phase = openPhase(source, each.volume, progress);
        ASSERT_TRUE(phase) << phase.error().message;
        EXPECT_EQ(phase->measured()->value(2, 3, 4), 100.0 * double(each.volume) + 1.0);
        EXPECT_EQ(phase->volumeIndex, each.volume);
        EXPECT_EQ(phasesOf(*phase), phases) << "each of them knows the others";
        EXPECT_EQ(phaseSourceOf(*phase), source);
    }
    writeTimes(path, 1);
    EXPECT_FALSE(openPhase(source, 2, progress)) << "the file is another one by now";
    EXPECT_TRUE(phasesOf(*openStudy(path, progress)).empty()) << "one volume has no phases";
}

TEST(PhasesOf, AFileSaysWhatItsAxisIs) {
    VolumesOfFile of{.file = "a.nii", .count = 8, .axis = {.unit = "ms", .first = 0.0, .step = 2500.0}};
    EXPECT_EQ(labelOf(of, 3).english(), "time 7.5 s") << "the last is later than 10 s";
    of.axis.unit = "Hz";
    EXPECT_EQ(labelOf(of, 1).english(), "at 2500 Hz, which is no time");
    of.axis.unit.clear();
    EXPECT_EQ(labelOf(of, 1).english(), "at 2500, in a unit that the file does not name");
    of.axis.step.reset();
    EXPECT_EQ(labelOf(of, 1).english(), "the file does not say when");
}

class SharedPhases : public testing::Test {
  protected:
    // The means of all voxels in each phase, in the values of the images.
    std::vector<double> meansOf(const std::string& name) {
        const std::filesystem::path path = dicom::test::sharedData() / "planar/4_4d" / name;
        Progress progress;
        const auto study = openStudy(path, progress);
        EXPECT_TRUE(study);
        std::vector<double> means;
        if (!study || !study->found) return means;
        labels_.clear();
        for (const Phase& each : phasesOf(*study->found, study->volumeIndex)) {
            labels_ += each.label.english() + "|";
            const auto opened = openFoundVolume(study->found, each.volume, progress);
            EXPECT_TRUE(opened);
            if (!opened) continue;
            const Volume& volume = *opened->measured();
            double sum = 0.0;
            const glm::ivec3 size = volume.size();
            for (int k = 0; k < size.z; ++k)
                for (int j = 0; j < size.y; ++j)
                    for (int i = 0; i < size.x; ++i) sum += volume.value(i, j, k);
            means.push_back(sum / (double(size.x) * size.y * size.z));
        }
        return means;
    }

    std::string labels_;  // of the phases that meansOf() opened last
};

TEST_F(SharedPhases, AreThoseOfTheTruth) {
    if (!std::filesystem::exists(dicom::test::sharedData() / "planar/4_4d"))
        GTEST_SKIP() << "no ../shared/data/planar";
    const std::vector<double> breath = meansOf("made_ct4d_5_series");
    ASSERT_EQ(breath.size(), 5u);
    EXPECT_EQ(labels_,
              "CT 4D RESP Gated, 0%|CT 4D RESP Gated, 20%|CT 4D RESP Gated, 40%|"
              "CT 4D RESP Gated, 60%|CT 4D RESP Gated, 80%|");
    const std::array truth{-585.9108, -585.9109, -585.7581, -585.7581, -585.9109};
    for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(breath[i], truth.at(i), 2e-4) << i;
    const std::vector<double> contrast = meansOf("mr_dce_breast_6pos_3times");
    ASSERT_EQ(contrast.size(), 3u);
    EXPECT_NEAR(contrast[0], 16.4611, 1e-3);
    EXPECT_NEAR(contrast[1], 21.437, 1e-3);
    EXPECT_NEAR(contrast[2], 22.7939, 1e-3);
    EXPECT_EQ(meansOf("made_enhanced_mr_perfusion.dcm").size(), 5u);
    EXPECT_EQ(meansOf("made_pet_gated").size(), 6u);
}

}  // namespace
}  // namespace macula::study
