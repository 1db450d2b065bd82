// The doses of a folder, and what its regions receive: a plan made here, and one with truths made without
// this code.
#include "study/dose/dose_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "dicom/support.h"
#include "study/dose/dose_table.h"
#include "study/dose/found_dose.h"
#include "study/dose/made_plan.h"
#include "study/open/opened_study.h"

namespace macula::study {
namespace {

namespace fs = std::filesystem;

class DoseReportTest : public testing::Test {
  protected:
    void open(const fs::path& folder) {
        Progress progress;
        auto opened = openStudy(folder, progress);
        ASSERT_TRUE(opened) << opened.error().message;
        ASSERT_TRUE(opened->found);
        images_ = *std::move(opened);
        doses_ = dosesOn(*images_.found, images_.volumeIndex);
    }
    void make(const test::MadePlan& plan = {}) {
        test::writePlan(folder_.path(), plan);
        open(folder_.path());
    }
    Result<DoseReport> report(std::size_t dose) {
        Progress progress;
        MACULA_TRY(dose_, openFoundVolume(images_.found, dose, progress));
        return reportDose({.found = *images_.found,
                           .on = images_.volumeIndex,
                           .grid = *images_.volume,
                           .dose = dose,
                           .values = dose_.measured()},
                          progress);
    }
    static bool says(const std::vector<Text>& notes, std::string_view part) {
        return std::ranges::any_of(
            notes, [&](const Text& each) { return each.english().find(part) != std::string::npos; });
    }
    dicom::test::TemporaryFolder folder_;
    OpenedStudy images_;
    OpenedStudy dose_;
    std::vector<FoundDose> doses_;
};

TEST_F(DoseReportTest, TheDoseOfAPlanIsFoundWithItsPrescription) {
    make({.prescriptions = "30\\40"});
    EXPECT_EQ(images_.volume->modality(), "CT");
    EXPECT_FALSE(images_.dose);
    ASSERT_EQ(doses_.size(), 1u);
    const dicom::DoseFacts& facts = doses_[0].facts;
    EXPECT_EQ(facts.units, "GY");
    EXPECT_TRUE(facts.isPlanHere);
    EXPECT_EQ(facts.prescribedGy(), 40.0) << "not the 99 Gy of an organ at risk";
    EXPECT_EQ(facts.fractions, 20);
    EXPECT_EQ(doseText(facts).english(), "Dose of a whole plan, 40 Gy prescribed in 20 fractions");
    EXPECT_TRUE(says(doseNotes(facts), "2 prescriptions, from 30 to 40 Gy"));
}

TEST_F(DoseReportTest, APartOfAPlanHasNoPrescription) {
    make({.summation = "BEAM"});
    ASSERT_EQ(doses_.size(), 1u);
    EXPECT_FALSE(doses_[0].facts.prescribedGy());
    EXPECT_TRUE(says(doseNotes(doses_[0].facts), "not the dose of one whole plan"));
    const auto made = report(doses_[0].volume);
    ASSERT_TRUE(made);
    ASSERT_TRUE(made->reference);
    EXPECT_EQ(made->reference->of, DoseReference::Of::maximum);
    EXPECT_NEAR(made->reference->value, 44.0, 1e-5);
    EXPECT_TRUE(says(made->notes, "percentages are of the highest dose"));
}

TEST_F(DoseReportTest, WithoutThePlanNothingIsPrescribed) {
    make({.prescriptions = ""});
    ASSERT_EQ(doses_.size(), 1u);
    EXPECT_FALSE(doses_[0].facts.isPlanHere);
    EXPECT_TRUE(says(doseNotes(doses_[0].facts), "Its plan is not in the folder"));
}

TEST_F(DoseReportTest, ARelativeDoseIsNotInGy) {
    make({.units = "RELATIVE"});
    ASSERT_EQ(doses_.size(), 1u);
    EXPECT_FALSE(doses_[0].facts.prescribedGy());
    const auto made = report(doses_[0].volume);
    ASSERT_TRUE(made);
    EXPECT_FALSE(made->isInGy);
    EXPECT_NE(made->unit, "Gy");
    EXPECT_FALSE(figuresOf(made->regions.at(0), *made).v20Gy);
}

TEST_F(DoseReportTest, ADoseOfAnotherFrameOfReferenceIsNotOnTheImages) {
    make({.frameOfReferenceUid = "2.25.9999"});
    EXPECT_TRUE(doses_.empty());
    const auto& volumes = images_.found->volumes();
    const auto dose = std::ranges::find_if(
        volumes, [](const FoundVolume& each) { return each.series->modality == "RTDOSE"; });
    ASSERT_NE(dose, volumes.end());
    const auto made = report(std::size_t(dose - volumes.begin()));
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, ErrorCode::inputNotUsable);
}

TEST_F(DoseReportTest, RegionsHaveTheDosesOfTheirVoxels) {
    for (const bool areAbsolute : {false, true}) {
        SCOPED_TRACE(areAbsolute);
        make({.absoluteOffsets = areAbsolute});
        ASSERT_EQ(doses_.size(), 1u);
        const auto made = report(doses_[0].volume);
        ASSERT_TRUE(made) << made.error().message;
        EXPECT_EQ(dose_.volume->unitName(), "Gy");
        EXPECT_EQ(made->unit, "Gy");
        EXPECT_TRUE(made->isInGy);
        ASSERT_EQ(made->regions.size(), 3u);
        const RegionInDose& box = made->regions[0];
        EXPECT_EQ(box.label, "BOX");
        EXPECT_EQ(box.dose.voxels, 9u * 9 * 5);
        EXPECT_EQ(box.dose.outside, 0u);
        const DoseFigures f = figuresOf(box, *made);
        EXPECT_NEAR(f.minimum, 16.0, 1e-4);
        EXPECT_NEAR(f.maximum, 32.0, 1e-4);
        EXPECT_NEAR(f.mean, 24.0, 1e-4);
        EXPECT_NEAR(f.d50, 24.0, 1e-4);
        EXPECT_NEAR(*f.v20Gy, 7.0 / 9.0, 0.002) << "x of -4 to 8";
        EXPECT_EQ(*f.v95, 0.0) << "38 Gy";
        EXPECT_EQ(made->regions[1].dose.voxels, 2u * 9 * 5);
        EXPECT_NEAR(made->regions[1].dose.histogram.mean(), 41.0, 1e-4);
        EXPECT_TRUE(made->regions[2].dose.histogram.isEmpty());
    }
}

TEST_F(DoseReportTest, TheTableHasALineForEachRegion) {
    make();
    ASSERT_EQ(doses_.size(), 1u);
    auto made = report(doses_[0].volume);
    ASSERT_TRUE(made);
    made->regions[0].label = "=HYPERLINK(\"x\")";
    const std::string csv = doseCsv(*made);
    EXPECT_EQ(std::ranges::count(csv, '\n'), 4);
    EXPECT_NE(csv.find("\"'=HYPERLINK(\"\"x\"\")\""), std::string::npos) << csv;
    EXPECT_NE(csv.find(",16,24,32,"), std::string::npos) << csv;
    const auto json = doseJson(*made);
    EXPECT_EQ(json["reference"]["of"], "prescription");
    EXPECT_EQ(json["regions"].size(), 3u);
    EXPECT_TRUE(json["regions"][2]["mean"].is_null());
}

TEST_F(DoseReportTest, OfARealPlanIsTheTruth) {
    SKIP_WITHOUT_SHARED_DATA();
    const fs::path data = dicom::test::sharedData() / "planar";
    if (!fs::is_directory(data)) GTEST_SKIP() << "the planar data are not on this machine";
    std::ifstream stream(data / "truth" / "3_radiotherapy.json");
    const auto truth = nlohmann::json::parse(stream);
    open(data / "3_radiotherapy" / "made_rt_full_hfs");
    ASSERT_EQ(doses_.size(), 1u);
    EXPECT_EQ(doses_[0].facts.prescribedGy(), 60.0);
    EXPECT_EQ(doses_[0].facts.fractions, 30);
    const auto made = report(doses_[0].volume);
    ASSERT_TRUE(made) << made.error().message;
    const DoseField field(dose_.measured());
    for (const auto& probe :
         truth["3_radiotherapy/made_rt_full_hfs/rtdose.dcm"]["rtdose"]["probes_trilinear"]) {
        const auto there = field.at({probe[0][0], probe[0][1], probe[0][2]});
        ASSERT_TRUE(there);
        EXPECT_NEAR(*there, probe[1].get<double>(), 2e-4);
    }
    const auto& regions = truth["_groups"]["made_rt_full_hfs"]["dose_in_rois_trilinear_at_ct_voxel_centres"];
    std::size_t compared = 0;
    for (const RegionInDose& region : made->regions) {
        if (!regions.contains(region.label)) continue;
        SCOPED_TRACE(region.label);
        ++compared;
        const auto& wanted = regions[region.label];
        const DoseFigures f = figuresOf(region, *made);
        const auto near = [&](const char* name, double value) {
            EXPECT_NEAR(value, wanted[name].get<double>(), 0.01 * wanted[name].get<double>()) << name;
        };
        near("mean", f.mean);
        near("max", f.maximum);
        // Contours on every third slice: Macula fills those between, the truth does not.
        const bool isFilled = region.dose.voxels == wanted["voxels"].get<std::size_t>();
        EXPECT_EQ(isFilled, region.label != "BOX every 3rd slice");
        if (isFilled) near("min", f.minimum);
        if (isFilled) near("D95", f.d95);
        near("D50", f.d50);
        near("D2", f.d2);
    }
    EXPECT_EQ(compared, regions.size());
}

}  // namespace
}  // namespace macula::study
