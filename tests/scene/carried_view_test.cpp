// What stays when one phase follows another.
#include "scene/state/carried_view.h"
#include "study/open/same_place.h"

#include <gtest/gtest.h>

#include "study/found_by_hand.h"

namespace macula::scene {
namespace {

std::shared_ptr<const Volume> volumeWith(std::uint16_t highest, const glm::dmat4& worldFromVoxel) {
    auto made = Volume::create({.size = glm::ivec3(2), .worldFromVoxel = worldFromVoxel, .modality = "MR"},
                               {0, 1, 2, 3, 4, 5, 6, highest});
    return std::make_shared<const Volume>(*std::move(made));
}

// Phases 0 and 1, and a series of the same grid that is none.
class CarriedView : public testing::Test {
  protected:
    CarriedView() {
        dicom::Scan scan;
        std::vector<dicom::Stack> phases{study::test::volumeOf(2, "MR"), study::test::volumeOf(2, "MR")};
        for (int n = 0; n < 2; ++n) {
            phases[std::size_t(n)].phase = n;
            phases[std::size_t(n)].phases = 2;
        }
        scan.studies.push_back(
            study::test::studyOf(0, "DOE^JANE", "20240301", "Breast",
                                 {study::test::seriesOf(2, "DCE", std::move(phases), "MR"),
                                  study::test::seriesOf(3, "T2", {study::test::volumeOf(2, "MR")}, "MR")}));
        found_ = std::make_shared<const study::FoundVolumes>(std::move(scan));
    }
    study::OpenedStudy opened(std::size_t index, std::uint16_t highest,
                              const glm::dmat4& worldFromVoxel = glm::dmat4(1.0)) const {
        study::OpenedStudy study{.volume = volumeWith(highest, worldFromVoxel)};
        study.seriesDigest = index < 2 ? "dce" : "t2";
        study.found = found_;
        study.volumeIndex = index;
        study.frameOfReferenceUid = "1.2.3";
        return study;
    }

    std::shared_ptr<const study::FoundVolumes> found_;
};

TEST_F(CarriedView, PhasesHaveOnePlaceAndOneWindow) {
    const study::OpenedStudy first = opened(0, 100);
    const study::OpenedStudy second = opened(1, 300);
    EXPECT_TRUE(study::arePhases(first, second));
    SliceState before;
    before.crosshairMm = glm::dvec3(1.0, 0.0, 1.0);
    before.asAcquired = true;
    before.slab.thicknessMm = 4.0;
    before.isInverted = true;
    const SliceState after = carriedSlices(first, before, second, {});
    EXPECT_EQ(after.crosshairMm, before.crosshairMm);
    EXPECT_TRUE(after.asAcquired && after.isInverted);
    EXPECT_EQ(after.slab, before.slab);
    ASSERT_TRUE(after.window) << "nobody chose one, and that of the second is another";
    EXPECT_DOUBLE_EQ(after.window->width, 100.0);
    const SliceState back = carriedSlices(second, after, first, {});
    EXPECT_EQ(back, after);
}

TEST_F(CarriedView, AnotherSeriesOfTheSameGridKeepsItsWindow) {
    const study::OpenedStudy dce = opened(0, 100);
    const study::OpenedStudy t2 = opened(2, 900);
    EXPECT_TRUE(study::staysInPlace(dce, t2));
    EXPECT_FALSE(study::arePhases(dce, t2));
    SliceState before;
    before.crosshairMm = glm::dvec3(1.0);
    before.window = DisplayWindow{.center = 3.0, .width = 4.0, .explanation = {}, .function = {}};
    const SliceState after = carriedSlices(dce, before, t2, {});
    EXPECT_EQ(after.crosshairMm, before.crosshairMm);
    EXPECT_FALSE(after.window);
}

TEST_F(CarriedView, ElsewhereAndOfOthersNothingStays) {
    const study::OpenedStudy dce = opened(0, 100);
    SliceState before;
    before.crosshairMm = glm::dvec3(1.0);
    const auto isAfresh = [&](const study::OpenedStudy& next) {
        return !study::staysInPlace(dce, next) && carriedSlices(dce, before, next, {}) == SliceState{};
    };
    EXPECT_TRUE(isAfresh(opened(1, 100, affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0.01}))));
    study::OpenedStudy other = opened(2, 100);
    other.frameOfReferenceUid = "1.2.4";
    EXPECT_TRUE(isAfresh(other)) << "another frame of reference";
    other = opened(1, 100);
    other.identity = {.patientName = "ROE^RICHARD", .patientId = "9", .birthDate = "19500101", .sex = "M"};
    study::OpenedStudy hers = dce;
    hers.identity = {.patientName = "DOE^JANE", .patientId = "7", .birthDate = "19700101", .sex = "F"};
    EXPECT_FALSE(study::shareGrid(hers, other));
    EXPECT_TRUE(isAfresh(dce)) << "opened again it is as it was left";
    EXPECT_FALSE(study::staysInPlace({}, dce));
}

}  // namespace
}  // namespace macula::scene
