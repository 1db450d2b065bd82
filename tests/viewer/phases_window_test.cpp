// Phases in the window: chosen, played, measured over time, opened.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QClipboard>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QSlider>
#include <QTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include "dicom/support.h"
#include "dicom/synthetic.h"
#include "formats/nifti_bytes.h"
#include "viewer/phases/phase_bar.h"
#include "viewer/slices/slice_view.h"
#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

constexpr int kPhases = 4;
constexpr double kStep = 1000.0;  // values of a phase above those of the one before

class PhasesWindowTest : public WindowTest {
  protected:
    PhasesWindowTest() {
        refusesRaw_ = false;
        layout_ = scene::Layout::fourPanes;
    }

    void openPhases() {
        dicom::test::SyntheticSeries series;
        series.phases = kPhases;
        series.phaseStep = kStep;
        std::vector<dicom::test::Slice> slices = slicesOf(series);
        for (dicom::test::Slice& slice : slices)
            slice.edits.push_back([ms = 100 * slice.phase](DcmItem& item) {
                dicom::test::put(item, DCM_TriggerTime, std::to_string(ms).c_str());
            });
        writeFiles(folder_.path(), series, slices);
        window_->open(folder_.path());
        ASSERT_TRUE(waitUntil([this] { return window_->hasStudy() && !window_->loading(); }));
        ASSERT_TRUE(waitUntil([this] { return axial().isUpToDate() && axial().shownFrame(); }));
    }
    SliceView& axial() { return window_->slices(slices::Orientation::axial); }
    PhaseBar& bar() { return *window_->findChild<PhaseBar*>(QStringLiteral("phase-bar")); }
    void choose(int phase) { bar().findChild<QSlider*>(QStringLiteral("phases-slider"))->setValue(phase); }
    void click(const char* name) { bar().findChild<QAbstractButton*>(QLatin1String(name))->click(); }
    bool shows(const QString& words) {
        return waitUntil(
            [&] { return axial().isUpToDate() && axial().tags().join(QLatin1Char(' ')).contains(words); });
    }
    // The value in the middle of the pane.
    double probed() {
        QMouseEvent event(QEvent::MouseMove, QPointF(axial().rect().center()),
                          axial().mapToGlobal(axial().rect().center()), Qt::NoButton, Qt::NoButton,
                          Qt::NoModifier);
        QApplication::sendEvent(&axial(), &event);
        return axial().probedText().split(QLatin1Char(' ')).first().toDouble();
    }

    dicom::test::TemporaryFolder folder_;
};

TEST_F(PhasesWindowTest, SlicesShowThePhaseThatIsChosen) {
    openPhases();
    EXPECT_TRUE(bar().isVisible());
    ASSERT_TRUE(shows(QStringLiteral("Phase 1 of 4")));
    const double first = probed();
    choose(2);
    ASSERT_TRUE(shows(QStringLiteral("Phase 3 of 4")));
    EXPECT_TRUE(axial().tags().join(QLatin1Char(' ')).contains(QStringLiteral("saved values: phase 1")));
    EXPECT_NEAR(probed() - first, 2.0 * kStep, 1.0);
    EXPECT_FALSE(axial().tags().join(QLatin1Char(' ')).contains(QStringLiteral("phase 1 of"))) << "its names";
    EXPECT_TRUE(
        axial().notes().join(QLatin1Char(' ')).contains(QStringLiteral("Segments are of the open phase")));
    choose(0);
    ASSERT_TRUE(shows(QStringLiteral("Phase 1 of 4")));
    EXPECT_NEAR(probed(), first, 0.5);
    EXPECT_FALSE(window_->session().canUndo()) << "which phase is seen is no change of the study";

    window_->open(std::nullopt);  // the phantom has no phases
    ASSERT_TRUE(waitUntil([this] { return !bar().isVisible(); }));
    EXPECT_FALSE(axial().tags().join(QLatin1Char(' ')).contains(QStringLiteral("Phase")));
}

// A NIfTI file of four times, 1.5 s apart; values are 100 times the number of the volume.
TEST_F(PhasesWindowTest, VolumesOfAFileArePhases) {
    formats::test::NiftiBytes file = formats::test::makeNifti(4, 2);
    file.set<std::int16_t>(40, 4);
    file.set<std::int16_t>(48, 4);
    file.set(92, 1.5f);
    file.bytes[123] = char(2 | 8);
    file.bytes.resize(352 + std::size_t(4 * 120));
    for (int n = 0; n < 4 * 60; ++n)
        file.set<std::int16_t>(352 + 2 * std::size_t(n), std::int16_t(100 * (n / 60) + n % 60));
    formats::test::writeBytes(folder_ / "times.nii", file.bytes);
    window_->open(folder_ / "times.nii");
    ASSERT_TRUE(waitUntil([this] { return window_->hasStudy() && !window_->loading(); }));
    ASSERT_TRUE(shows(QStringLiteral("Phase 1 of 4")));
    const double first = probed();
    choose(3);
    ASSERT_TRUE(shows(QStringLiteral("Phase 4 of 4, time 4500 ms")));
    EXPECT_NEAR(probed() - first, 300.0, 1e-6);
    click("phases-open");
    ASSERT_TRUE(waitUntil([this] { return window_->session().study().volumeIndex == 3; }));
    EXPECT_EQ(window_->session().study().measured()->value(0, 0, 0), 300.0);
    ASSERT_TRUE(shows(QStringLiteral("Phase 4 of 4")));
    choose(0);
    ASSERT_TRUE(shows(QStringLiteral("saved values: phase 4")));
}

TEST_F(PhasesWindowTest, PlayingLeavesNoneOut) {
    openPhases();
    ASSERT_TRUE(shows(QStringLiteral("Phase 1 of 4")));
    QStringList seen;
    QObject::connect(&axial(), &SliceView::pictureShown, &*window_, [&] {
        const QString tags = axial().tags().join(QLatin1Char(' '));
        const QString phase = tags.mid(tags.indexOf(QStringLiteral("Phase ")), 7);
        if (seen.isEmpty() || seen.back() != phase) seen << phase;
    });
    click("phases-play");
    ASSERT_TRUE(waitUntil([&] { return seen.size() >= 9; }));
    click("phases-play");
    for (int i = 1; i < 9; ++i) {
        const int before = seen[i - 1].last(1).toInt();
        EXPECT_EQ(seen[i].last(1).toInt(), before % kPhases + 1) << seen.join(QLatin1Char('|')).toStdString();
    }
}

TEST_F(PhasesWindowTest, TheCurveHasTheMeanOfEachPhase) {
    openPhases();
    click("phases-curve");
    ASSERT_TRUE(waitUntil([this] { return window_->message().contains(QStringLiteral("No ellipse")); }));
    window_->session().change(QStringLiteral("Ellipse"), [this](scene::StudyState& next) {
        slices::Ellipse ellipse{.plane = axial().shownFrame()->plane, .radiiMm = {2.0, 2.0}};
        ellipse.plane.centreMm =
            axial().shownFrame()->worldFromPicture(0.5 * glm::dvec2(axial().shownFrame()->sizePx));
        next.measurements = {{.label = "aorta", .shape = ellipse}};
    });
    click("phases-curve");
    QDialog* dialog = nullptr;
    ASSERT_TRUE(waitUntil([&] {
        dialog = window_->findChild<QDialog*>(QStringLiteral("time-curve-dialog"));
        return dialog != nullptr;
    }));
    dialog->findChild<QAbstractButton*>(QStringLiteral("time-curve-copy"))->click();
    const QStringList lines = QGuiApplication::clipboard()->text().split(QStringLiteral("\r\n"));
    ASSERT_EQ(lines.size(), kPhases + 2);
    EXPECT_TRUE(lines[0].contains(QStringLiteral("aorta mean")));
    const double first = lines[1].split(QLatin1Char(',')).at(3).toDouble();
    for (int phase = 1; phase < kPhases; ++phase)
        EXPECT_NEAR(lines[phase + 1].split(QLatin1Char(',')).at(3).toDouble() - first, phase * kStep, 1.0);
    dialog->close();
}

TEST_F(PhasesWindowTest, A3dPictureFollowsWhereThatIsWanted) {
    openPhases();
    ASSERT_TRUE(waitUntil([this] { return frames_ > 0; }));
    choose(2);
    ASSERT_TRUE(shows(QStringLiteral("Phase 3 of 4")));
    EXPECT_FALSE(window_->viewport().showsOtherPhase()) << "off until a person wants it";
    EXPECT_TRUE(
        axial().tags().join(QLatin1Char(' ')).contains(QStringLiteral("3D and saved values: phase 1")));
    const Camera camera = toCamera(window_->viewport().camera());
    const std::shared_ptr<const Volume> open = window_->session().study().volume;

    click("phases-3d");
    ASSERT_TRUE(waitUntil([this] { return last_ && last_->phase == 3; }));
    EXPECT_TRUE(window_->viewport().showsOtherPhase());
    EXPECT_NE(window_->viewport().volume(), open);
    EXPECT_EQ(window_->session().study().volume, open) << "what is saved stays with it";
    EXPECT_FALSE(axial().tags().join(QLatin1Char(' ')).contains(QStringLiteral("3D and")));
    EXPECT_TRUE(axial().tags().join(QLatin1Char(' ')).contains(QStringLiteral("saved values: phase 1")));
    choose(1);
    ASSERT_TRUE(waitUntil([this] { return last_ && last_->phase == 2; }));
    EXPECT_EQ(toCamera(window_->viewport().camera()), camera);
    EXPECT_EQ(last_->camera, camera);
    // A picture of phase 2 would be saved as one of phase 1.
    window_->findChild<QAction*>(QStringLiteral("save-picture"))->trigger();
    EXPECT_TRUE(waitUntil([this] { return window_->message().contains(QStringLiteral("another phase")); }));

    click("phases-3d");
    ASSERT_TRUE(waitUntil([this] { return last_ && last_->phase == 0; }));
    EXPECT_EQ(window_->viewport().volume(), open);
    EXPECT_FALSE(window_->session().canUndo());
    click("phases-3d");
    ASSERT_TRUE(waitUntil([this] { return last_ && last_->phase == 2; }));
    window_->open(std::nullopt);  // another study begins with its own volume
    ASSERT_TRUE(waitUntil([this] { return !bar().isVisible() && last_ && last_->phase == 0; }));
    EXPECT_FALSE(window_->viewport().showsOtherPhase());
}

TEST_F(PhasesWindowTest, Playing3dLeavesNoneOut) {
    openPhases();
    std::vector<std::uint64_t> seen;
    QObject::connect(&*window_, &MainWindow::frameShown, &*window_, [&](const live::FrameShown& frame) {
        if (frame.phase > 0 && (seen.empty() || seen.back() != frame.phase)) seen.push_back(frame.phase);
    });
    click("phases-3d");
    click("phases-play");
    ASSERT_TRUE(waitUntil([&] { return seen.size() >= 7; }));
    click("phases-play");
    for (std::size_t i = 1; i < 7; ++i) EXPECT_EQ(seen[i], seen[i - 1] % kPhases + 1);
}

TEST_F(PhasesWindowTest, ADifferenceIsThatOfTheValuesAndSaysSo) {
    openPhases();
    choose(2);
    ASSERT_TRUE(shows(QStringLiteral("Phase 3 of 4")));
    auto* reference = bar().findChild<QComboBox*>(QStringLiteral("phases-difference"));
    auto* reach = bar().findChild<QDoubleSpinBox*>(QStringLiteral("phases-reach"));
    EXPECT_FALSE(reach->isVisible());
    reference->setCurrentIndex(1);  // phase 1
    ASSERT_TRUE(shows(QStringLiteral("phase 3 − phase 1")));
    EXPECT_NEAR(probed(), 2.0 * kStep, 0.5);
    EXPECT_TRUE(axial().probedText().contains(QStringLiteral("difference")))
        << axial().probedText().toStdString();
    EXPECT_NEAR(reach->value(), 2.0 * kStep, 0.5);
    EXPECT_TRUE(reach->isVisible());
    // Numbers of windows are for values.
    const auto before = window_->session().state();
    QTest::keyClick(&axial(), Qt::Key_3);
    EXPECT_EQ(window_->session().state(), before);
    choose(1);
    ASSERT_TRUE(shows(QStringLiteral("phase 2 − phase 1")));
    EXPECT_NEAR(probed(), kStep, 0.5);
    EXPECT_NEAR(reach->value(), 2.0 * kStep, 0.5) << "one colour means one difference in all phases";
    choose(0);
    ASSERT_TRUE(shows(QStringLiteral("phase 1 − phase 1")));
    EXPECT_NEAR(probed(), 0.0, 1e-6);
    reference->setCurrentIndex(0);
    ASSERT_TRUE(shows(QStringLiteral("Phase 1 of 4")));
    EXPECT_FALSE(axial().probedText().contains(QStringLiteral("difference")));
}

TEST_F(PhasesWindowTest, APhaseIsOpened) {
    openPhases();
    choose(3);
    ASSERT_TRUE(shows(QStringLiteral("Phase 4 of 4")));
    click("phases-open");
    ASSERT_TRUE(waitUntil([this] {
        return !window_->loading() &&
               !axial().tags().join(QLatin1Char(' ')).contains(QStringLiteral("saved values"));
    }));
    EXPECT_TRUE(shows(QStringLiteral("Phase 4 of 4")));
}

}  // namespace
}  // namespace macula::viewer
