// The segmentations of a study under a real hand: found, loaded, on slices, in 3D, and undone.
#include "viewer/segmentation/segmentation_panel.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcdeftag.h>
#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <QTreeWidget>
#include <stdexcept>

#include "pipeline/volume/mask_bits.h"
#include "study/open/opened_study.h"
#include "support.h"
#include "synthetic_segmentation.h"
#include "viewer/offscreen.h"
#include "viewer/volume/hidden_voxels.h"
#include "viewer/volume/shown_additions.h"

namespace macula::viewer {
namespace {

class SegmentationPanelTest : public test::OffscreenTest {
  protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        series_.size = {21, 19, 17};
        dicom::test::writeFiles(folder_ / "ct", series_);
        centreMm_ = transformPoint(series_.worldFromVoxel, {10, 9, 8});
        dicom::test::SyntheticSegmentation seg;
        seg.size = series_.size;
        seg.worldFromVoxel = series_.worldFromVoxel;
        seg.parts = {{.number = 1, .label = "Liver", .share = ball(6.45)},
                     {.number = 2, .label = "Tumour", .share = ball(3.0)}};
        dicom::test::writeSegmentation(folder_ / "seg/a", seg);
        seg.frameOfReferenceUid = "2.25.77";
        seg.sopInstanceUid = "2.25.4444";
        seg.seriesUid = "2.25.4445";
        dicom::test::writeSegmentation(folder_ / "seg/b", seg);
        session_.emplace(scene::Catalogue{});
        keeper_.emplace(*session_);
        hidden_.emplace();
        panel_.emplace(*session_, *keeper_);
        QObject::connect(
            &*keeper_, &SegmentationKeeper::maskMade, &*hidden_,
            [this](const std::optional<Mask>& mask) { hidden_->set(HiddenVoxels::Part::segments, mask); });
        panel_->resize(400, 500);
        panel_->show();
    }
    void TearDown() override {
        panel_.reset();
        hidden_.reset();
        keeper_.reset();
        session_.reset();
        OffscreenTest::TearDown();
    }

    std::function<double(const glm::dvec3&)> ball(double radiusMm) const {
        return [centre = centreMm_, radiusMm](const glm::dvec3& mm) {
            return glm::distance(mm, centre) <= radiusMm ? 1.0 : 0.0;
        };
    }
    void openFolder() {
        Progress progress;
        auto study = study::openStudy(folder_.path(), progress);
        ASSERT_TRUE(study) << study.error().message;
        hidden_->setVolume(study->volume);
        session_->show(*std::move(study), {});
        ASSERT_TRUE(settled());
    }
    bool settled() {
        return waitUntil([this] { return keeper_->isAtRest() && !hidden_->isJoining(); });
    }
    void showFirst() {
        segmentation().setCheckState(0, Qt::Checked);
        ASSERT_TRUE(settled());
    }

    template <class Widget>
    Widget& find(const char* name) {
        auto* found = panel_->findChild<Widget*>(QLatin1String(name));
        if (found == nullptr) throw std::runtime_error(name);
        return *found;
    }
    QTreeWidget& tree() { return find<QTreeWidget>("segments"); }
    QTreeWidgetItem& segmentation() { return *tree().topLevelItem(0); }
    QTreeWidgetItem& segment(int n) { return *segmentation().child(n); }
    void select(int n) { tree().setCurrentItem(&segment(n)); }
    void click(const char* name) { QTest::mouseClick(&find<QPushButton>(name), Qt::LeftButton); }
    // How many voxels are left in 3D; all: nothing is hidden.
    std::size_t left() {
        const Volume& volume = *session_->study().volume;
        if (!hidden_->mask()) return volume.voxelCount();
        const MaskBits bits = maskBits(*hidden_->mask(), volume);
        std::size_t count = 0;
        for (int k = 0; k < bits.size.z; ++k)
            for (int j = 0; j < bits.size.y; ++j)
                for (int i = 0; i < bits.size.x; ++i) count += bits.shows(i, j, k) ? 1 : 0;
        return count;
    }
    std::size_t voxelsOf(std::uint16_t number) const {
        return keeper_->loaded(keeper_->found().front().digest)->segment(number)->voxels->count();
    }

    dicom::test::TemporaryFolder folder_;
    dicom::test::SyntheticSeries series_;
    glm::dvec3 centreMm_{0.0};
    std::optional<StudyEditor> session_;
    std::optional<SegmentationKeeper> keeper_;
    std::optional<HiddenVoxels> hidden_;
    std::optional<SegmentationPanel> panel_;
};

TEST_F(SegmentationPanelTest, VolumesInUncalibratedImagesSayThatTheyAreEstimates) {
    openFolder();
    showFirst();
    const QString ml = segment(0).text(1);
    EXPECT_TRUE(ml.front().isDigit()) << ml.toStdString();
    EXPECT_FALSE(find<QLabel>("segments-notes").text().contains(QStringLiteral("not calibrated")));

    series_.edits.push_back([this](DcmItem& item) {
        dicom::test::erase(item, DCM_PixelSpacing);
        dicom::test::put(item, DCM_ImagerPixelSpacing,
                         dicom::test::decimals({glm::length(glm::dvec3(series_.worldFromVoxel[1])),
                                                glm::length(glm::dvec3(series_.worldFromVoxel[0]))}));
    });
    std::filesystem::remove_all(folder_ / "ct");
    dicom::test::writeFiles(folder_ / "ct", series_);
    openFolder();
    showFirst();
    EXPECT_EQ(segment(0).text(1), QStringLiteral("≈ ") + ml);
    EXPECT_TRUE(segment(0).toolTip(1).contains(QStringLiteral("not calibrated")));
    EXPECT_TRUE(find<QLabel>("segments-notes").text().contains(QStringLiteral("not calibrated")));
}

TEST_F(SegmentationPanelTest, InColourASegmentIsTintedIn3d) {
    openFolder();
    ShownAdditions shown(*session_, *keeper_);
    const auto atRest = [&] { return settled() && waitUntil([&] { return shown.isAtRest(); }); };
    select(1);
    auto& opacity = find<QSlider>("segment-opacity-3d");
    EXPECT_FALSE(opacity.isEnabled());
    click("segment-coloured");
    EXPECT_EQ(segmentation().checkState(0), Qt::Checked) << "what is in colour is shown";
    ASSERT_TRUE(atRest());
    ASSERT_TRUE(shown.additions() && shown.additions()->tints);
    const SegmentTints tints = *shown.additions()->tints;
    EXPECT_EQ(std::size_t(std::ranges::count(tints.box->voxels, std::uint8_t{1})), voxelsOf(2));
    EXPECT_TRUE(segment(1).text(2).contains(QLatin1String("in colour")));
    ASSERT_TRUE(opacity.isEnabled());
    EXPECT_EQ(opacity.value(), 100);
    opacity.setValue(30);
    ASSERT_TRUE(atRest());
    ASSERT_TRUE(shown.additions() && shown.additions()->tints);
    EXPECT_FLOAT_EQ(shown.additions()->tints->colours.front().opacity, 0.3f);
    panel_->setColour(QColor(0, 255, 0));
    ASSERT_TRUE(atRest());
    EXPECT_EQ(shown.additions()->tints->colours.front().rgb, glm::vec3(0.0f, 1.0f, 0.0f));
    EXPECT_EQ(shown.additions()->tints->box, tints.box) << "colours are a table beside it";
    EXPECT_EQ(left(), session_->study().volume->voxelCount()) << "nothing is hidden by it";
    click("segment-coloured");
    EXPECT_EQ(shown.additions(), nullptr);
}

// The voxels of segments are gone through once, however fast a hand moves a slider; each step is seen at
// once.
TEST_F(SegmentationPanelTest, InColourASliderGoesThroughNoVoxels) {
    openFolder();
    ShownAdditions shown(*session_, *keeper_);
    std::vector<std::shared_ptr<const TintBox>> boxes;
    QObject::connect(&shown, &ShownAdditions::changed, &shown, [&] {
        if (shown.additions()) boxes.push_back(shown.additions()->tints->box);
    });
    const auto atRest = [&] { return settled() && waitUntil([&] { return shown.isAtRest(); }); };
    showFirst();
    select(1);
    click("segment-coloured");
    auto& opacity = find<QSlider>("segment-opacity-3d");
    // While they are gone through: the first picture has the newest opacity.
    for (int percent = 90; percent >= 50; percent -= 10) opacity.setValue(percent);
    EXPECT_TRUE(boxes.empty());
    ASSERT_TRUE(atRest());
    ASSERT_EQ(boxes.size(), 1u);
    EXPECT_FLOAT_EQ(shown.additions()->tints->colours.front().opacity, 0.5f);
    for (int percent = 40; percent >= 0; percent -= 10) {
        opacity.setValue(percent);
        EXPECT_TRUE(shown.isAtRest());
        EXPECT_FLOAT_EQ(shown.additions()->tints->colours.front().opacity, float(percent) / 100.0f);
    }
    // Away and back is the same geometry, another segment is another one.
    click("segment-coloured");
    EXPECT_EQ(shown.additions(), nullptr);
    click("segment-coloured");
    EXPECT_TRUE(shown.additions());
    EXPECT_EQ(std::ranges::count(boxes, boxes.front()), std::ptrdiff_t(boxes.size()));
    select(0);
    click("segment-coloured");
    ASSERT_TRUE(atRest());
    ASSERT_TRUE(shown.additions());
    EXPECT_NE(shown.additions()->tints->box, boxes.front());
    EXPECT_EQ(shown.additions()->tints->colours.size(), 2u);
    shown.forget();
    EXPECT_EQ(shown.additions(), nullptr);
}

// Of another segmentation on slices the picture in 3D is not begun anew.
TEST_F(SegmentationPanelTest, InColourAnotherSegmentationThatIsLoadedChangesNothing) {
    dicom::test::SyntheticSegmentation other;
    other.size = series_.size;
    other.worldFromVoxel = series_.worldFromVoxel;
    other.sopInstanceUid = "2.25.5555";
    other.seriesUid = "2.25.5556";
    other.parts = {{.number = 1, .label = "Kidney", .share = ball(5.0)},
                   {.number = 2, .label = "Cyst", .share = ball(2.0)}};
    dicom::test::writeSegmentation(folder_ / "seg/c", other);
    openFolder();
    ASSERT_TRUE(keeper_->found().at(1).canBeShown());
    ShownAdditions shown(*session_, *keeper_);
    int told = 0;
    QObject::connect(&shown, &ShownAdditions::changed, &shown, [&] { ++told; });
    const auto atRest = [&] { return settled() && waitUntil([&] { return shown.isAtRest(); }); };
    select(1);
    click("segment-coloured");
    ASSERT_TRUE(atRest());
    ASSERT_EQ(told, 1);
    const auto before = shown.additions();
    ASSERT_TRUE(before);
    tree().topLevelItem(1)->setCheckState(0, Qt::Checked);
    ASSERT_TRUE(atRest());
    ASSERT_EQ(keeper_->allLoaded().size(), 2u);
    EXPECT_EQ(told, 1);
    EXPECT_EQ(shown.additions(), before);
}

TEST_F(SegmentationPanelTest, WithoutAStudyItSaysWhatToDo) {
    EXPECT_EQ(tree().topLevelItemCount(), 0);
    EXPECT_EQ(find<QLabel>("segments-notes").text(), QLatin1String("Open a study first."));
    EXPECT_FALSE(find<QSlider>("segment-opacity").isEnabled());
    session_->show(smallStudy(), {});  // of no folder
    ASSERT_TRUE(settled());
    EXPECT_TRUE(find<QLabel>("segments-notes").text().contains(QLatin1String("no segmentations")));
    EXPECT_TRUE(keeper_->note().isEmpty());
}

TEST_F(SegmentationPanelTest, ListsWhatIsThereWithTheReasonWhyItCannotBeShown) {
    openFolder();
    ASSERT_EQ(tree().topLevelItemCount(), 2);
    ASSERT_EQ(segmentation().childCount(), 2);
    EXPECT_EQ(segment(0).text(0), QLatin1String("Liver"));
    EXPECT_EQ(segment(1).text(1), QStringLiteral("–")) << "not loaded yet";
    EXPECT_EQ(segmentation().checkState(0), Qt::Unchecked);
    EXPECT_FALSE(keeper_->shown());
    QTreeWidgetItem& other = *tree().topLevelItem(1);
    EXPECT_FALSE(other.flags().testFlag(Qt::ItemIsUserCheckable));
    ASSERT_EQ(other.childCount(), 1);
    EXPECT_TRUE(other.child(0)->text(0).contains(QLatin1String("frame of reference")));
    EXPECT_TRUE(keeper_->note().contains(QLatin1String("F11")));
    EXPECT_TRUE(segmentation().text(0).contains(QLatin1String("ORGANS")));
    panel_->showNames(false);
    EXPECT_FALSE(segmentation().text(0).contains(QLatin1String("ORGANS")));
}

TEST_F(SegmentationPanelTest, AMarkShowsItOnSlicesWithItsVolume) {
    openFolder();
    showFirst();
    ASSERT_TRUE(keeper_->shown());
    ASSERT_EQ(keeper_->shown()->size(), 2u);
    EXPECT_EQ(keeper_->shown()->at(0).label, "Liver");
    const double det = std::abs(glm::determinant(glm::dmat3(session_->study().volume->worldFromVoxel())));
    const double ml = double(voxelsOf(1)) * det / 1000.0;
    EXPECT_NEAR(QLocale().toDouble(segment(0).text(1)), ml, 0.006);
    segment(0).setCheckState(0, Qt::Unchecked);
    ASSERT_EQ(keeper_->shown()->size(), 1u);
    EXPECT_EQ(keeper_->shown()->at(0).label, "Tumour");
    session_->undo();
    EXPECT_EQ(segment(0).checkState(0), Qt::Checked);
    EXPECT_EQ(keeper_->shown()->size(), 2u);
    session_->undo();
    EXPECT_EQ(segmentation().checkState(0), Qt::Unchecked);
    EXPECT_FALSE(keeper_->shown());
    EXPECT_FALSE(session_->canUndo());
}

TEST_F(SegmentationPanelTest, AloneAndHideChangeWhatIsLeftIn3d) {
    openFolder();
    const std::size_t all = left();
    select(1);
    click("segment-hide");  // shows it, too
    ASSERT_TRUE(settled());
    EXPECT_EQ(segmentation().checkState(0), Qt::Checked);
    EXPECT_EQ(left(), all - voxelsOf(2));
    EXPECT_EQ(segment(1).text(2), QLatin1String("hidden"));
    EXPECT_EQ(hidden_->mask()->remark, "a segment left out");
    select(0);
    click("segment-alone");
    ASSERT_TRUE(settled());
    EXPECT_EQ(left(), voxelsOf(1) - voxelsOf(2)) << "the tumour lies in the liver";
    session_->undo();
    ASSERT_TRUE(settled());
    EXPECT_EQ(left(), all - voxelsOf(2));
    select(1);
    EXPECT_TRUE(find<QPushButton>("segment-hide").isChecked());
    click("segment-alone");
    ASSERT_TRUE(settled());
    EXPECT_FALSE(find<QPushButton>("segment-hide").isChecked());
    EXPECT_EQ(left(), voxelsOf(2));
    click("segment-alone");
    ASSERT_TRUE(settled());
    EXPECT_EQ(left(), all);
    EXPECT_FALSE(hidden_->mask());
}

// What was chosen for 3D is then that of the picture again, and no step of undo.
TEST_F(SegmentationPanelTest, WhatCannotBeHiddenIsNotChosen) {
    openFolder();
    const std::size_t all = left();
    select(1);
    click("segment-hide");
    ASSERT_TRUE(settled());
    const scene::StudyState before = session_->state();
    const QString undone = session_->undoText();
    std::optional<Error> told;
    QObject::connect(&*keeper_, &SegmentationKeeper::failed, [&](const Error& error) { told = error; });
    select(0);
    click("segment-alone");
    ASSERT_NE(session_->state(), before);
    Q_EMIT keeper_->refused(
        {ErrorCode::outOfMemory, Text("There is not enough memory to hide segments."), {}, {}});
    EXPECT_EQ(session_->state(), before);
    EXPECT_EQ(session_->undoText(), undone);
    EXPECT_FALSE(session_->canRedo());
    ASSERT_TRUE(told);
    ASSERT_TRUE(settled());
    EXPECT_EQ(left(), all - voxelsOf(2));
    EXPECT_EQ(segment(0).text(2), QString());
    EXPECT_EQ(segment(1).text(2), QLatin1String("hidden"));

    select(0);
    click("segment-alone");  // may be asked for again
    ASSERT_TRUE(settled());
    EXPECT_EQ(left(), voxelsOf(1) - voxelsOf(2));
}

// As the table and segments are.
TEST_F(SegmentationPanelTest, SeveralPartsHideTogether) {
    openFolder();
    showFirst();
    const Volume& volume = *session_->study().volume;
    auto labels = LabelMap::create(volume.size(), volume.worldFromVoxel(), {},
                                   std::vector<std::uint16_t>(volume.voxelCount(), 0));
    Mask nothing;
    nothing.labels = std::make_shared<const LabelMap>(*std::move(labels));
    nothing.remark = Text("all left out");
    select(0);
    click("segment-alone");
    ASSERT_TRUE(settled());
    EXPECT_EQ(left(), voxelsOf(1));
    hidden_->set(HiddenVoxels::Part::table, nothing);
    EXPECT_TRUE(hidden_->isJoining());
    ASSERT_TRUE(settled());
    EXPECT_EQ(left(), 0u);
    EXPECT_EQ(hidden_->mask()->remark, "all left out, one segment alone");
    hidden_->set(HiddenVoxels::Part::table, std::nullopt);
    EXPECT_EQ(left(), voxelsOf(1)) << "at once";
}

TEST_F(SegmentationPanelTest, ColourOpacityAndCentre) {
    openFolder();
    select(1);
    EXPECT_FALSE(find<QPushButton>("segment-centre").isEnabled()) << "not loaded";
    showFirst();
    select(1);
    panel_->setColour(QColor(10, 20, 30));
    EXPECT_EQ(keeper_->shown()->at(1).rgb, (std::array<std::uint8_t, 3>{10, 20, 30}));
    auto& opacity = find<QSlider>("segment-opacity");
    EXPECT_EQ(opacity.value(), 40);
    QTest::keyClick(&opacity, Qt::Key_End);
    EXPECT_EQ(keeper_->shown()->at(1).opacity, 1.0);
    session_->undo();
    EXPECT_EQ(opacity.value(), 40);
    click("segment-centre");
    ASSERT_TRUE(session_->state().slices.crosshairMm);
    EXPECT_LT(glm::distance(*session_->state().slices.crosshairMm, centreMm_), 1e-3);
}

TEST_F(SegmentationPanelTest, CancelTakesBackWhatIsNotThereYet) {
    openFolder();
    bool began = false;
    bool ended = false;
    QObject::connect(&*keeper_, &SegmentationKeeper::began, [&] { began = true; });
    QObject::connect(&*keeper_, &SegmentationKeeper::ended, [&] { ended = true; });
    segmentation().setCheckState(0, Qt::Checked);
    EXPECT_TRUE(began);
    keeper_->cancel();
    EXPECT_TRUE(ended);
    EXPECT_EQ(segmentation().checkState(0), Qt::Unchecked);
    ASSERT_TRUE(settled());
    EXPECT_FALSE(keeper_->shown());
    showFirst();
    EXPECT_TRUE(keeper_->shown()) << "it can be asked for again";
}

TEST_F(SegmentationPanelTest, AStateThatIsOpenedAgainShowsThemAndWhatIsGoneIsTold) {
    openFolder();
    select(0);
    click("segment-alone");
    ASSERT_TRUE(settled());
    const scene::StudyState state = session_->state();
    const std::size_t alone = left();
    study::OpenedStudy study = session_->study();
    hidden_->setVolume(study.volume);
    session_->show(study, state);
    ASSERT_TRUE(settled());
    EXPECT_EQ(left(), alone);
    EXPECT_TRUE(keeper_->shown());
    study.found.reset();
    hidden_->setVolume(study.volume);
    session_->show(study, state);
    ASSERT_TRUE(settled());
    EXPECT_FALSE(keeper_->shown());
    EXPECT_TRUE(keeper_->note().contains(QLatin1String("not in the folder")));
}

}  // namespace
}  // namespace macula::viewer
