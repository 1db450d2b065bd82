// Own segments under a real hand, on slices without a display: painted, grown, changed, undone.
#include "viewer/segmenting/segment_work.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>

#include "segment/brush.h"
#include "viewer/segmentation/segmentation_panel.h"
#include "viewer/segmenting/program_run.h"
#include "viewer/segmenting/segment_stroke.h"
#include "viewer/segmenting/segmenting_panel.h"
#include "viewer/slice_view_fixture.h"

namespace macula::viewer {
namespace {

using slices::Orientation;

class SegmentingTest : public SliceViewTest {
  protected:
    void SetUp() override {
        keeper_.emplace(*session_);
        work_.emplace(*session_, *keeper_);
        stroke_.emplace(*session_, *keeper_, *work_);
        list_.emplace(*session_, *keeper_);
        panel_.emplace(*session_, *work_);
        QObject::connect(&*work_, &SegmentWork::failed, &*work_,
                         [this](const Error& error) { error_ = error.message.english(); });
        showStudy();
        session_->change("Cross-hair",
                         [](scene::StudyState& next) { next.slices.crosshairMm = test::kBlockCentreMm; });
        axial_ = pane(Orientation::axial);
        axial_->setBrush(&*stroke_);
        axial_->setTool(SliceTool::segment);
    }
    void TearDown() override {
        axial_.reset();
        panel_.reset();
        list_.reset();
        stroke_.reset();
        work_.reset();
        keeper_.reset();
    }
    bool done() {
        return waitUntil([this] { return !work_->isWorking() && settled(*axial_); });
    }
    std::size_t count(std::uint16_t number = 1) {
        const auto& own = keeper_->own();
        return own && own->segment(number) != nullptr ? own->segment(number)->voxels->count() : 0;
    }
    void click(const char* name) {
        auto* button = panel_->findChild<QPushButton*>(QLatin1String(name));
        ASSERT_NE(button, nullptr) << name;
        ASSERT_TRUE(button->isEnabled()) << name;
        button->click();
        ASSERT_TRUE(done());
    }
    void set(const char* name, double value) {
        panel_->findChild<QDoubleSpinBox*>(QLatin1String(name))->setValue(value);
    }
    void choose(const char* name, int index) {
        panel_->findChild<QComboBox*>(QLatin1String(name))->setCurrentIndex(index);
    }
    QString text(const char* name) { return panel_->findChild<QLabel*>(QLatin1String(name))->text(); }
    const Volume& volume() { return *session_->study().volume; }

    std::optional<SegmentationKeeper> keeper_;
    std::optional<SegmentWork> work_;
    std::optional<SegmentStroke> stroke_;
    std::optional<SegmentationPanel> list_;
    std::optional<SegmentingPanel> panel_;
    std::unique_ptr<SliceView> axial_;
    std::string error_;
};

TEST_F(SegmentingTest, ADragPaintsABallAndEachStrokeIsOneUndoStep) {
    set("segment-radius", 3.0);
    const QPoint at = placeOf(*axial_, {0.0, 0.0, 12.0});
    SliceViewTest::click(*axial_, at);
    ASSERT_TRUE(done());
    ASSERT_TRUE(keeper_->own());
    const glm::dvec3 mm = axial_->shownFrame()->worldFromPicture(glm::dvec2(at.x(), at.y()));
    const VoxelSet ball = segment::voxelsUnder({mm, mm, 3.0}, volume().worldFromVoxel(), volume().size());
    EXPECT_TRUE(*keeper_->own()->segment(1)->voxels == ball);
    EXPECT_EQ(keeper_->own()->segment(1)->segment.algorithm, "MANUAL");
    EXPECT_FALSE(session_->state().measurements.size());
    const std::size_t one = count();

    drag(*axial_, Qt::LeftButton, at, at + QPoint(60, 0));
    ASSERT_TRUE(done());
    const std::size_t two = count();
    EXPECT_GT(two, one);
    choose("segment-brush", 1);
    SliceViewTest::click(*axial_, at);
    ASSERT_TRUE(done());
    EXPECT_EQ(count(), two - one) << "erased where the first ball was";

    EXPECT_EQ(session_->undoText(), QStringLiteral("Erase"));
    session_->undo();
    EXPECT_EQ(count(), two);
    session_->undo();
    EXPECT_EQ(count(), one);
    session_->redo();
    EXPECT_EQ(count(), two);
    session_->undo();
    session_->undo();
    EXPECT_EQ(count(), 0u) << "a new segment, still empty";
    session_->undo();
    EXPECT_TRUE(keeper_->own()->segments.empty());
    EXPECT_TRUE(keeper_->found().empty());
    session_->redo();
    session_->redo();
    EXPECT_EQ(count(), one);
}

TEST_F(SegmentingTest, TheSegmentIsListedAsOnesOwnAndSeenOnSlices) {
    const QPoint at = placeOf(*axial_, {0.0, 0.0, 12.0});
    const QRgb before = pictureOf(*axial_).pixel(at + QPoint(4, 4));
    SliceViewTest::click(*axial_, at);
    ASSERT_TRUE(done());
    axial_->setSegments(keeper_->shown());
    ASSERT_TRUE(settled(*axial_));
    EXPECT_NE(pictureOf(*axial_).pixel(at + QPoint(4, 4)), before);
    auto* tree = list_->findChild<QTreeWidget*>(QStringLiteral("segments"));
    ASSERT_EQ(tree->topLevelItemCount(), 1);
    EXPECT_EQ(tree->topLevelItem(0)->text(0), QStringLiteral("Own segments"));
    EXPECT_TRUE(tree->topLevelItem(0)->font(0).italic());
    EXPECT_EQ(tree->topLevelItem(0)->checkState(0), Qt::Checked);
    EXPECT_TRUE(tree->topLevelItem(0)->child(0)->text(1).contains(QLatin1Char('.')));
    // Another revision of the same segment stays selected.
    list_->select({keeper_->own()->digest, std::uint16_t(1)});
    SliceViewTest::click(*axial_, at + QPoint(30, 0));
    ASSERT_TRUE(done());
    ASSERT_TRUE(list_->selected());
    EXPECT_EQ(list_->selected()->number, std::uint16_t(1));
    EXPECT_EQ(list_->selected()->digest, keeper_->own()->digest);
    ASSERT_TRUE(waitUntil([this] { return work_->statistics().has_value(); }));
    EXPECT_TRUE(text("segment-statistics").contains(QStringLiteral("Mean 0.00, SD 0.00")))
        << text("segment-statistics").toStdString();
}

TEST_F(SegmentingTest, AThresholdIsSeenBeforeItCounts) {
    set("segment-low", 500.0);
    set("segment-high", 2000.0);
    click("segment-threshold");
    ASSERT_TRUE(work_->hasPreview());
    EXPECT_EQ(work_->preview()->count(), 7u * 7u * 5u) << "the block";
    EXPECT_FALSE(keeper_->own());
    ASSERT_TRUE(keeper_->shown());
    EXPECT_EQ(keeper_->shown()->size(), 1u);
    EXPECT_TRUE(text("segment-preview").contains(QStringLiteral("0.490 ml")))
        << text("segment-preview").toStdString();
    set("segment-low", -500.0);  // the preview follows
    ASSERT_TRUE(done());
    EXPECT_EQ(work_->preview()->count(), volume().voxelCount());
    set("segment-low", 500.0);
    ASSERT_TRUE(done());
    click("segment-add");
    EXPECT_FALSE(work_->hasPreview());
    EXPECT_EQ(count(), 245u);
    EXPECT_EQ(keeper_->own()->segment(1)->segment.algorithm, "SEMIAUTOMATIC");

    choose("segment-filter", int(SegmentFilter::grow));
    set("segment-amount", 1.0);
    click("segment-apply");
    EXPECT_EQ(count(), 245u + 2u * 7u * 5u + 2u * 7u * 5u) << "by 1 mm: no voxel along k, where they have 2";
    choose("segment-filter", int(SegmentFilter::shrink));
    click("segment-apply");
    EXPECT_EQ(count(), 245u) << "closing a block changes nothing";
    session_->undo();
    session_->undo();
    EXPECT_EQ(count(), 245u);
}

TEST_F(SegmentingTest, AClickGrowsWhatIsConnectedWithIt) {
    choose("segment-brush", 2);
    set("segment-tolerance", 100.0);
    SliceViewTest::click(*axial_, placeOf(*axial_, test::kBlockCentreMm));
    ASSERT_TRUE(done());
    ASSERT_TRUE(work_->hasPreview());
    EXPECT_EQ(work_->preview()->count(), 245u);
    click("segment-replace");
    EXPECT_EQ(count(), 245u);
    // A limit, and that it was reached.
    set("segment-most", 1.0);
    SliceViewTest::click(*axial_, placeOf(*axial_, {5.0, 5.0, 12.0}));
    ASSERT_TRUE(done());
    EXPECT_EQ(work_->preview()->count(), 500u);
    EXPECT_TRUE(text("segment-preview").contains(QStringLiteral("may have leaked")));
    click("segment-drop");
    EXPECT_FALSE(work_->hasPreview());
    EXPECT_EQ(count(), 245u);
    // At an edge of the block nothing is like its surroundings.
    set("segment-tolerance", 10.0);
    SliceViewTest::click(*axial_, placeOf(*axial_, {-16.0, -9.0, 12.0}));
    ASSERT_TRUE(done());
    EXPECT_NE(error_.find("differs from its surroundings"), std::string::npos) << error_;
}

TEST_F(SegmentingTest, ASegmentIsNamedDeletedAndBroughtBack) {
    work_->addSegment(QStringLiteral("Liver"));
    work_->addSegment({});
    ASSERT_EQ(keeper_->own()->segments.size(), 2u);
    EXPECT_EQ(keeper_->own()->segment(2)->segment.label, "Segment 2");
    EXPECT_EQ(work_->selected(), std::uint16_t(2));
    work_->rename(QStringLiteral("Spleen"));
    EXPECT_EQ(keeper_->own()->segment(2)->segment.label, "Spleen");
    work_->removeSegment();
    EXPECT_EQ(keeper_->own()->segments.size(), 1u);
    EXPECT_FALSE(work_->selected());
    session_->undo();
    EXPECT_EQ(keeper_->own()->segment(2)->segment.label, "Spleen");
    // A hidden one stays in the state, and in the list.
    session_->change("Hide", [this](scene::StudyState& next) {
        auto choice = scene::choiceOf(next.segmentations, keeper_->own()->digest);
        choice.isShown = false;
        scene::choose(next.segmentations, choice);
    });
    ASSERT_EQ(session_->state().segmentations.size(), 1u);
    EXPECT_EQ(keeper_->found().size(), 1u);
    EXPECT_FALSE(keeper_->shown());
}

TEST_F(SegmentingTest, WhatIsUndoneMeanwhileIsNotChangedLater) {
    SliceViewTest::click(*axial_, placeOf(*axial_, {0.0, 0.0, 12.0}));
    ASSERT_TRUE(done());
    work_->apply(SegmentFilter::grow, 3.0);
    session_->undo();
    ASSERT_TRUE(done());
    EXPECT_EQ(count(), 0u);
}

TEST_F(SegmentingTest, AProgramGetsTheVolumeAndGivesSegments) {
    ProgramRun run;
    std::vector<scene::OwnSegment> found;
    std::optional<Error> error;
    QObject::connect(&run, &ProgramRun::succeeded, &run,
                     [&](const std::vector<scene::OwnSegment>& segments) { found = segments; });
    QObject::connect(&run, &ProgramRun::failed, &run, [&](const Error& e) { error = e; });
    const auto runs = [&](const char* command, int minutes = 1) {
        found.clear();
        error.reset();
        const auto started = run.start({.command = QString::fromUtf8(command), .minutesMost = minutes},
                                       session_->study().measured());
        return started && waitUntil([&] { return !run.isRunning(); });
    };
    EXPECT_FALSE(runs("true {input}")) << "no place for a result";
    // The volume has 0 HU, and 1000 in the block: so it is a map of numbers, too.
    ASSERT_TRUE(runs("sh -c \"cp $0 $1\" {input} {output}"));
    ASSERT_EQ(found.size(), 1u) << (error ? error->message.english() : std::string());
    EXPECT_EQ(found[0].segment.number, 1000);
    EXPECT_EQ(found[0].voxels->count(), 245u);
    ASSERT_TRUE(runs("sh -c \"echo no model >&2; exit 3\" {input} {output}"));
    ASSERT_TRUE(error);
    EXPECT_NE(error->message.english().find("code 3"), std::string::npos);
    EXPECT_NE(error->hint.english().find("no model"), std::string::npos);
    ASSERT_TRUE(runs("true {input} {output}"));
    EXPECT_NE(error->message.english().find("no result"), std::string::npos);
    ASSERT_TRUE(runs("/no/such/program {input} {output}"));
    EXPECT_NE(error->message.english().find("could not be started"), std::string::npos);
    ASSERT_TRUE(runs("sh -c \"echo nonsense > $1\" {input} {output}"));
    EXPECT_TRUE(error);
    // A cancel kills what a script has started, too.
    ASSERT_TRUE(run.start({.command = QStringLiteral("sh -c \"sleep 300 & wait\" {input} {output}")},
                          session_->study().measured()));
    waitUntil([] { return false; }, 1);
    run.cancel();
    EXPECT_FALSE(run.isRunning());
}

}  // namespace
}  // namespace macula::viewer
