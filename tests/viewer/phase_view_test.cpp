// Phases of one series, one after the other and beside each other. On Qt's platform without a screen.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QTest>

#include "scene/state/carried_view.h"
#include "study/found_by_hand.h"
#include "viewer/second/second_volume_bar.h"
#include "viewer/second_fixture.h"

namespace macula::viewer {
namespace {

// Two phases on one grid; the second is twice as bright.
class PhaseViewTest : public SecondVolumeTest {
  protected:
    void SetUp() override {
        SecondVolumeTest::SetUp();
        dicom::Scan scan;
        std::vector<dicom::Stack> phases{study::test::volumeOf(21), study::test::volumeOf(21)};
        for (int n = 0; n < 2; ++n) {
            phases[std::size_t(n)].phase = n;
            phases[std::size_t(n)].phases = 2;
        }
        scan.studies.push_back(study::test::studyOf(0, "DOE^JANE", "20240301", "Thorax",
                                                    {study::test::seriesOf(3, "DCE", std::move(phases))}));
        found_ = std::make_shared<const study::FoundVolumes>(std::move(scan));
        session_->show(phase(0), {});
        ASSERT_TRUE(settled());
    }
    study::OpenedStudy phase(std::size_t index) const {
        VolumeOptions options = test::sliceVolumeOptions();
        options.windows.front().width = index == 0 ? 1000.0 : 2000.0;
        options.windows.front().center = index == 0 ? 500.0 : 1000.0;
        study::OpenedStudy study = studyOf(test::sliceVolume(std::move(options)), "dce", "20240301");
        study.found = found_;
        study.volumeIndex = index;
        study.frameOfReferenceUid = "1.2.3";
        for (int k = 0; k < 21; ++k) study.imageNumbers.push_back((index == 0 ? 91 : 151) + k);
        return study;
    }

    // Texts may lie over some of it.
    static int brightestOfBlock(SliceView& view) {
        int brightest = 0;
        for (const double x : {-2.0, 0.0, 2.0}) {
            for (const double y : {-2.0, 0.0, 2.0})
                brightest =
                    std::max(brightest, qGray(colourAt(view, test::kBlockCentreMm + glm::dvec3(x, y, 0))));
        }
        return brightest;
    }

    std::shared_ptr<const study::FoundVolumes> found_;
};

TEST_F(PhaseViewTest, ZoomAndPlaceStayWhenThePhaseChanges) {
    turnWheel(study(), 4, Qt::ControlModifier);
    ASSERT_TRUE(settled());
    const auto before = study().shownFrame();
    scene::StudyState next;
    next.slices = scene::carriedSlices(phase(0), state().slices, phase(1), {});
    session_->show(phase(1), next);
    ASSERT_TRUE(settled());
    EXPECT_EQ(study().shownFrame(), before);
    EXPECT_TRUE(study().positionText().endsWith("image 161")) << study().positionText().toStdString();
    // Another study is seen as a whole.
    session_->show(studyOf(test::sliceVolume(), "other", "20240302"), {});
    ASSERT_TRUE(settled());
    EXPECT_GT(study().shownFrame()->mmPerPixel, before->mmPerPixel);
}

TEST_F(PhaseViewTest, BesideEachOtherTheyHaveOneWindowUntilSomebodyPartsThem) {
    secondVolume_->offer(phase(1));
    ASSERT_NE(secondVolume_->state(), nullptr);
    EXPECT_TRUE(secondVolume_->state()->linksWindow);
    EXPECT_EQ(secondVolume_->state()->link, scene::SecondVolumeLink::sameFrame);
    session_->change("Place", [](scene::StudyState& next) {
        next.layout = scene::Layout::fourPanes;
        next.slices.crosshairMm = test::kBlockCentreMm;
    });
    ASSERT_TRUE(settled());
    EXPECT_EQ(brightestOfBlock(second()), brightestOfBlock(study())) << "its own window would make it grey";
    QTest::keyClick(&second(), Qt::Key_4);
    ASSERT_TRUE(state().slices.window);
    EXPECT_DOUBLE_EQ(state().slices.window->center, 400.0);
    EXPECT_FALSE(state().secondVolume->window);

    SecondVolumeBar bar(*session_, *secondVolume_);
    auto* one = bar.findChild<QCheckBox*>("beside-one-window");
    ASSERT_NE(one, nullptr);
    EXPECT_TRUE(one->isChecked());
    one->click();
    EXPECT_FALSE(state().secondVolume->linksWindow);
    ASSERT_TRUE(state().secondVolume->window) << "nothing jumps";
    EXPECT_DOUBLE_EQ(state().secondVolume->window->center, 400.0);
    QTest::keyClick(&second(), Qt::Key_3);
    EXPECT_DOUBLE_EQ(state().slices.window->center, 400.0);
    EXPECT_DOUBLE_EQ(state().secondVolume->window->center, -600.0);
}

// Slice 17 of both, which is image 107 of one and 167 of the other.
TEST_F(PhaseViewTest, EachPaneNamesItsOwnImage) {
    secondVolume_->offer(phase(1));
    session_->change("Place", [](scene::StudyState& next) {
        next.layout = scene::Layout::fourPanes;
        next.slices.crosshairMm = test::kBlockCentreMm;
    });
    ASSERT_TRUE(settled());
    EXPECT_EQ(study().positionText(), "Axial S 12.0 mm, slice 17 of 21, image 107");
    EXPECT_EQ(second().positionText(),
              "In the plane of the study: Axial S 12.0 mm, slice 17 of 21, image 167");
}

// A second volume whose slices lie across the pane has no slice to name.
TEST_F(PhaseViewTest, APlaneAcrossTheSecondVolumeNamesNoImage) {
    VolumeOptions options = test::sliceVolumeOptions();
    const glm::dmat4 standing = affine({1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {0, 0, 0});
    options.worldFromVoxel = standing * options.worldFromVoxel;
    study::OpenedStudy across = studyOf(test::sliceVolume(std::move(options)), "across", "20220301");
    across.frameOfReferenceUid = "1.2.3";
    for (int k = 0; k < 21; ++k) across.imageNumbers.push_back(21 - k);
    secondVolume_->offer(across);
    session_->change("Place", [](scene::StudyState& next) { next.layout = scene::Layout::fourPanes; });
    ASSERT_TRUE(settled());
    EXPECT_EQ(second().positionText(), "In the plane of the study: Axial S 0.0 mm");
}

}  // namespace
}  // namespace macula::viewer
