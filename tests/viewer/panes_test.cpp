// Four panes, driven as a person drives them: a study is opened, changed, cut, measured, written to files,
// closed, and found again.
#include "viewer/panes/pane_grid.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QFileDialog>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QtTest/QTest>
#include <fstream>
#include <stdexcept>

#include "base/atomic_file.h"
#include "scene/transfer/same_transfer.h"
#include "viewer/output/picture_dialog.h"
#include "viewer/slices/slice_view.h"
#include "viewer/transfer/transfer_function_editor.h"
#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

using slices::Orientation;

class PanesTest : public WindowTest {
  protected:
    PanesTest() { layout_ = scene::Layout::fourPanes; }
    void SetUp() override {
        sessions_ = folder_.filePath(QStringLiteral("sessions")).toStdString();
        WindowTest::SetUp();
        if (window_) window_->resize(1000, 800);
    }

    void openPhantom() {
        window_->open(std::nullopt);
        ASSERT_TRUE(waitUntil([&] { return window_->hasStudy() && slicesAreShown(); }));
    }
    bool slicesAreShown() {
        for (const Orientation o : {Orientation::axial, Orientation::coronal, Orientation::sagittal}) {
            if (pane(o).isVisible() && !pane(o).isUpToDate()) return false;
        }
        return true;
    }
    SliceView& pane(Orientation orientation) { return window_->slices(orientation); }
    QAction& action(const char* name) {
        auto* found = window_->findChild<QAction*>(QString::fromLatin1(name));
        if (found == nullptr) throw std::runtime_error(name);
        return *found;
    }
    static void drag(QWidget& in, QPoint from, QPoint to) {
        QTest::mousePress(&in, Qt::LeftButton, {}, from);
        for (int step = 1; step <= 4; ++step) QTest::mouseMove(&in, from + (to - from) * step / 4);
        QTest::mouseRelease(&in, Qt::LeftButton, {}, to);
    }
    // As somebody who types the name and presses Enter.
    void answerWith(const std::string& path) {
        QFileDialog* dialog = nullptr;
        ASSERT_TRUE(waitUntil([&] {
            for (auto* each : window_->findChildren<QFileDialog*>()) {
                if (each->isVisible()) dialog = each;
            }
            return dialog != nullptr;
        }));
        dialog->selectFile(QString::fromStdString(path));
        QMetaObject::invokeMethod(dialog, "accept");
    }
    std::string fileOf(const char* name) { return folder_.filePath(QString::fromLatin1(name)).toStdString(); }

    QTemporaryDir folder_;
};

TEST_F(PanesTest, SlicesAreThereBeforeTheVolume) {
    window_->open(std::nullopt);
    ASSERT_TRUE(waitUntil([&] { return window_->hasStudy() && slicesAreShown(); }));
    EXPECT_TRUE(pane(Orientation::axial).positionText().startsWith(QLatin1String("Axial")));
    ASSERT_TRUE(waitForConverged());
    EXPECT_GT(coloursInTheMiddle(), 10);
}

TEST_F(PanesTest, AClickInOnePaneMovesTheOthers) {
    openPhantom();
    SliceView& axial = pane(Orientation::axial);
    const QPoint at(axial.width() / 2 + 30, axial.height() / 2 - 20);
    QTest::mouseClick(&axial, Qt::LeftButton, {}, at);
    const auto crosshair = window_->state().slices.crosshairMm;
    ASSERT_TRUE(crosshair);
    ASSERT_TRUE(waitUntil([&] { return slicesAreShown(); }));
    for (const Orientation o : {Orientation::coronal, Orientation::sagittal}) {
        // Within half a voxel: where panes go along voxels, planes are those of voxels.
        EXPECT_LT(std::abs(pane(o).shownFrame()->distanceMm(*crosshair)), 2.0) << int(o);
    }
    EXPECT_GT(crosshair->x, pane(Orientation::axial).shownFrame()->plane.centreMm.x)
        << "the patient's left is at the right";
}

TEST_F(PanesTest, APaneFillsTheWindowAndComesBack) {
    openPhantom();
    QTest::mouseDClick(&pane(Orientation::coronal), Qt::LeftButton);
    EXPECT_EQ(window_->state().layout, scene::Layout::coronal);
    EXPECT_TRUE(window_->panes().isShown(Pane::coronal));
    EXPECT_FALSE(window_->panes().isShown(Pane::volume));
    QTest::mouseDClick(&pane(Orientation::coronal), Qt::LeftButton);
    EXPECT_EQ(window_->state().layout, scene::Layout::fourPanes);
    // The volume's native window lives on.
    ASSERT_TRUE(waitForConverged());
    EXPECT_GT(coloursInTheMiddle(), 10);
}

TEST_F(PanesTest, WhatIsDoubleClickedInTheVolumeIsShownOnSlices) {
    openPhantom();
    ASSERT_TRUE(waitForConverged());
    VulkanWindow& target = window_->viewport().window();
    sendMouse(QEvent::MouseButtonDblClick, {0.5 * target.width(), 0.5 * target.height()}, Qt::LeftButton,
              Qt::LeftButton);
    ASSERT_TRUE(waitUntil([&] { return window_->state().slices.crosshairMm.has_value(); }));
    const glm::dvec3 found = *window_->state().slices.crosshairMm;
    EXPECT_LT(found.y, 0.0) << "from the front, the surface is in the front half";
    EXPECT_LT(glm::distance(window_->viewport().camera().targetMm, found), 1e-9);
}

TEST_F(PanesTest, ADrivenSessionIsFoundAgain) {
    openPhantom();
    const scene::StudyState first = window_->state();

    // A preset, from the list.
    for (QComboBox* box : window_->findChildren<QComboBox*>()) {
        if (box->accessibleName() != QLatin1String("Preset")) continue;
        box->setCurrentIndex(box->findText(QStringLiteral("Cinematic bone")));
        Q_EMIT box->activated(box->currentIndex());
    }
    ASSERT_NE(window_->state().preset->name, first.preset->name);

    // Its curve, by a right drag that shifts it: one step, and a copy.
    const std::string chosen = window_->state().preset->name;
    auto* editor = window_->findChild<TransferFunctionEditor*>();
    editor->parentWidget()->show();
    TransferCurve& curve = editor->curve();
    ASSERT_TRUE(waitUntil([&] { return curve.isVisible() && !editor->isCounting(); }));
    const QPoint middle = curve.plotRect().center().toPoint();
    QTest::mousePress(&curve, Qt::RightButton, {}, middle);
    QTest::mouseMove(&curve, middle + QPoint(15, 0));
    QTest::mouseMove(&curve, middle + QPoint(30, 0));
    QTest::mouseRelease(&curve, Qt::RightButton, {}, middle + QPoint(30, 0));
    EXPECT_NE(window_->state().preset->name, chosen);

    // A clip, a distance, and one pane.
    action("clip-left-half").trigger();
    ASSERT_TRUE(window_->state().clip);
    action("slice-tool-distance").trigger();
    SliceView& axial = pane(Orientation::axial);
    ASSERT_TRUE(waitUntil([&] { return slicesAreShown(); }));
    const QPoint centre = axial.rect().center();
    drag(axial, centre, centre + QPoint(60, 0));
    ASSERT_EQ(window_->state().measurements.size(), 1u);
    const auto distance = std::get<slices::Distance>(window_->state().measurements[0].shape);
    EXPECT_NEAR(slices::lengthMm(distance), 60.0 * axial.devicePixelRatioF() * axial.shownFrame()->mmPerPixel,
                1e-6);
    QTest::mouseDClick(&axial, Qt::LeftButton, {}, QPoint(20, axial.height() / 2));
    EXPECT_EQ(window_->state().layout, scene::Layout::axial);

    // All of it can be undone, and done again.
    const scene::StudyState made = window_->state();
    while (window_->session().canUndo()) window_->session().undo();
    EXPECT_EQ(window_->state().preset->name, first.preset->name);
    EXPECT_TRUE(window_->state().measurements.empty());
    while (window_->session().canRedo()) window_->session().redo();
    EXPECT_EQ(window_->state(), made);

    window_.reset();
    makeWindow();
    openPhantom();
    const scene::StudyState again = window_->state();
    EXPECT_TRUE(scene::isSame(*again.preset, *made.preset));
    EXPECT_EQ(again.clip, made.clip);
    EXPECT_EQ(again.measurements, made.measurements);
    EXPECT_EQ(again.layout, made.layout);
    EXPECT_EQ(again.slices, made.slices);
}

TEST_F(PanesTest, FilesAreWritten) {
    openPhantom();
    action("save-measurements").trigger();
    EXPECT_TRUE(window_->message().contains(QLatin1String("no measurements")));
    action("slice-tool-ellipse").trigger();
    const QPoint centre = pane(Orientation::coronal).rect().center();
    drag(pane(Orientation::coronal), centre - QPoint(30, 30), centre + QPoint(30, 30));
    ASSERT_EQ(window_->state().measurements.size(), 1u);
    action("save-measurements").trigger();
    answerWith(fileOf("table.csv"));
    ASSERT_TRUE(waitUntil([&] { return std::filesystem::exists(fileOf("table.csv")); }));
    EXPECT_NE(readText(fileOf("table.csv"))->find("ellipse"), std::string::npos);

    for (const auto& [name, begins] : {std::pair("picture.png", "\x89PNG"), std::pair("picture.dcm", "")}) {
        action("save-picture").trigger();
        auto* dialog = window_->findChild<PictureDialog*>();
        ASSERT_NE(dialog, nullptr);
        EXPECT_TRUE(dialog->hasOverlays()) << "sides of the patient, unless somebody wants none";
        const auto sides = dialog->findChildren<QSpinBox*>();
        ASSERT_EQ(sides.size(), 2);
        for (QSpinBox* side : sides) side->setValue(48);
        auto* fog = dialog->findChild<QDoubleSpinBox*>(QStringLiteral("picture-fog"));
        EXPECT_TRUE(fog->isEnabled());
        EXPECT_EQ(fog->text(), QStringLiteral("None"));
        fog->setValue(120.0);
        dialog->accept();
        answerWith(fileOf(name));
        ASSERT_TRUE(waitUntil([&] { return std::filesystem::exists(fileOf(name)); })) << name;
        EXPECT_EQ(readText(fileOf(name))->substr(0, std::string(begins).size()), begins);
        const bool tellsOfFog = readText(fileOf(name))->find("faded by fog of 120 mm") != std::string::npos;
        EXPECT_EQ(tellsOfFog, std::string(name) == "picture.dcm");
        ASSERT_TRUE(waitUntil([&] { return window_->message().contains(QLatin1String("is written")); }));
    }
}

}  // namespace
}  // namespace macula::viewer
