// Several images side by side: the grid, priors, boxes that scroll together, hanging protocols, undo, and
// what is kept.
#include <gtest/gtest.h>

#include <QAction>
#include <QDropEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMimeData>
#include <algorithm>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include "dicom/support.h"
#include "dicom/synthetic.h"
#include "study/hanging/kept_boxes.h"
#include "viewer/browser/series_mime.h"
#include "viewer/browser/study_browser.h"
#include "viewer/hanging/hanging_controller.h"
#include "viewer/panes/pane_grid.h"
#include "viewer/planar/image_box.h"
#include "viewer/planar/planar_controller.h"
#include "viewer/planar/planar_measuring.h"
#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

using dicom::test::put;
using dicom::test::SyntheticSeries;

class ImageBoxesTest : public WindowTest {
  protected:
    ImageBoxesTest() { refusesRaw_ = false; }

    // A film of 30 x 20 pixels, all of that value.
    void writeFilm(const char* modality, const char* study, const std::string& series, const char* date,
                   int value, const char* side = "", const char* view = "") {
        SyntheticSeries made;
        made.modality = modality;
        made.sopClassUid = std::string(modality) == "MG"
                               ? UID_DigitalMammographyXRayImageStorageForPresentation
                               : UID_DigitalXRayImageStorageForPresentation;
        made.patientName = "FILM^ANNA";
        made.studyUid = study;
        made.seriesUid = series;
        made.size = {30, 20, 1};
        made.intercept = 0.0;
        made.rawInstead = [value](const dicom::test::Slice&, int, int) { return value; };
        made.edits.push_back([=](DcmItem& item) {
            item.findAndDeleteElement(DCM_ImagePositionPatient);
            item.findAndDeleteElement(DCM_ImageOrientationPatient);
            item.findAndDeleteElement(DCM_PixelSpacing);
            put(item, DCM_StudyDate, date);
            put(item, DCM_ImageLaterality, side);
            put(item, DCM_ViewPosition, view);
            put(item, DCM_WindowCenter, "500");
            put(item, DCM_WindowWidth, "1000");
        });
        auto slices = slicesOf(made);
        slices.front().sopInstanceUid = series + ".1";
        slices.front().fileName = series + ".dcm";
        dicom::test::writeFiles(folder_.path(), made, slices);
    }
    // A CT of slices that are `stepMm` apart from `firstMm` on.
    void writeSlices(const char* study, const char* series, const char* date, int count, double firstMm,
                     double stepMm, const char* reference) {
        SyntheticSeries made;
        made.patientName = "SLICES^SAM";
        made.studyUid = study;
        made.seriesUid = series;
        made.frameOfReferenceUid = reference;
        made.size = {16, 16, count};
        made.worldFromVoxel = glm::dmat4(1.0);
        made.worldFromVoxel[2][2] = stepMm;
        made.worldFromVoxel[3] = {0.0, 0.0, firstMm, 1.0};
        made.rawInstead = [](const dicom::test::Slice& slice, int, int) { return 1000 + 10 * slice.place; };
        made.edits.push_back([=](DcmItem& item) { put(item, DCM_StudyDate, date); });
        auto slices = slicesOf(made);
        for (dicom::test::Slice& slice : slices) {
            slice.sopInstanceUid = std::string(series) + "." + std::to_string(slice.place + 1);
            slice.fileName = slice.sopInstanceUid + ".dcm";
        }
        dicom::test::writeFiles(folder_.path(), made, slices);
    }
    void restart() {
        window_.reset();
        makeWindow();
    }
    PlanarController& images() { return window_->images(); }
    ImageBoxes& boxes() { return images().boxes(); }
    ImageBox& box(std::size_t index) { return *boxes().boxes().at(index); }
    bool areUpToDate() {
        const auto all = boxes().boxes();
        return images().isShown() && std::ranges::all_of(all, [](const ImageBox* each) {
                   return !each->isShown() || each->isUpToDate();
               });
    }
    bool waitForBoxes(int rows, int columns) {
        return waitUntil(
            [=, this] { return boxes().rows() == rows && boxes().columns() == columns && areUpToDate(); });
    }
    std::string uidIn(std::size_t index) {
        return box(index).isShown() ? box(index).series().series->seriesInstanceUid : std::string();
    }
    std::string allUids() {
        std::string all;
        for (std::size_t i = 0; i < boxes().boxes().size(); ++i) all += uidIn(i) + " ";
        return all;
    }
    void press(std::size_t index, int key) {
        QKeyEvent event(QEvent::KeyPress, key, Qt::NoModifier);
        QApplication::sendEvent(&box(index).view(), &event);
    }
    void choose(std::size_t index) {
        // Without a window manager no window is active, and setFocus() sends no event.
        QFocusEvent event(QEvent::FocusIn);
        QApplication::sendEvent(&box(index).view(), &event);
        ASSERT_EQ(&boxes().chosen(), &box(index));
    }
    QAction& action(const char* name) {
        auto* found = window_->findChild<QAction*>(QLatin1String(name));
        EXPECT_NE(found, nullptr) << name;
        return *found;
    }
    void drawLineIn(std::size_t index, double row = 3.0) {
        PlanarView& view = box(index).view();
        box(index).measuring().setTool(study::ImageMeasurement::Kind::distance);
        const auto send = [&](QEvent::Type type, QPointF pixel, Qt::MouseButtons held) {
            const QPointF at = view.paneFromPicture().map(pixel);
            QMouseEvent event(type, at, view.mapToGlobal(at),
                              type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, held,
                              Qt::NoModifier);
            QApplication::sendEvent(&view, &event);
        };
        send(QEvent::MouseButtonPress, {3.0, row}, Qt::LeftButton);
        send(QEvent::MouseMove, {10.0, row}, Qt::LeftButton);
        send(QEvent::MouseMove, {20.0, row}, Qt::LeftButton);
        send(QEvent::MouseButtonRelease, {20.0, row}, Qt::NoButton);
        box(index).measuring().setTool({});
    }
    dicom::test::TemporaryFolder folder_;
};

TEST_F(ImageBoxesTest, AnXrayHangsBesideItsPrior) {
    writeFilm("DX", "2.25.1", "2.25.11", "20200101", 200);
    writeFilm("DX", "2.25.2", "2.25.21", "20240101", 800);
    // Opens the newer one's file: the study that is read.
    window_->open(folder_ / "2.25.21.dcm");
    ASSERT_TRUE(waitForBoxes(1, 2));
    EXPECT_EQ(allUids(), "2.25.21 2.25.11 ");
    EXPECT_GT(qGray(box(0).view().picture().pixel(5, 5)), qGray(box(1).view().picture().pixel(5, 5)));
    EXPECT_TRUE(box(0).view().isVisible());
    EXPECT_TRUE(box(1).view().isVisible());
    EXPECT_FALSE(window_->panes().isVisible());
    const auto identityOf = [&](std::size_t i) {
        return box(i).view().labels().identity.join(QLatin1Char(' '));
    };
    EXPECT_TRUE(identityOf(0).contains(QStringLiteral("2024-01-01"))) << identityOf(0).toStdString();
    EXPECT_TRUE(identityOf(1).contains(QStringLiteral("2020-01-01")));
}

TEST_F(ImageBoxesTest, MammogramsHangByTheirViewsAndUndoGoesBack) {
    int value = 100;
    for (const char* view : {"MLO", "CC"})
        for (const char* side : {"L", "R"}) {
            value += 100;
            writeFilm("MG", "2.25.1", std::string("2.25.1") + std::to_string(value), "20240101", value, side,
                      view);
        }
    window_->open(folder_.path());
    ASSERT_TRUE(waitForBoxes(2, 2));
    EXPECT_EQ(allUids(), "2.25.1500 2.25.1400 2.25.1300 2.25.1200 ") << "R CC, L CC, R MLO, L MLO";
    boxes().setGrid(1, 2);
    ASSERT_TRUE(waitForBoxes(1, 2));
    EXPECT_EQ(allUids(), "2.25.1500 2.25.1200 ") << "the chosen one, which was opened, stays";
    EXPECT_TRUE(action("undo").isEnabled());
    action("undo").trigger();
    ASSERT_TRUE(waitForBoxes(2, 2));
    EXPECT_EQ(allUids(), "2.25.1500 2.25.1400 2.25.1300 2.25.1200 ");
    action("redo").trigger();
    EXPECT_EQ(boxes().columns(), 2);
    EXPECT_EQ(boxes().rows(), 1);
}

TEST_F(ImageBoxesTest, ADropPutsASeriesIntoABoxAndSwapsTwo) {
    for (int n = 1; n <= 3; ++n) writeFilm("XA", "2.25.1", "2.25.1" + std::to_string(n), "20240101", 100 * n);
    window_->open(folder_.path());
    ASSERT_TRUE(waitForBoxes(1, 1));
    boxes().setGrid(1, 2);
    ASSERT_TRUE(waitForBoxes(1, 2));
    const auto found = box(0).found();
    const auto dropOn = [&](std::size_t index, const dicom::Stack& stack) {
        QMimeData data;
        data.setData(QLatin1String(kSeriesMime), seriesText(*found, stack));
        PlanarView& view = box(index).view();
        QDragEnterEvent enter(view.rect().center(), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&view, &enter);
        QDropEvent drop(view.rect().center(), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&view, &drop);
    };
    const std::string first = uidIn(0);
    const std::string second = uidIn(1);
    dropOn(0, *box(1).series().stack);
    EXPECT_EQ(allUids(), second + " " + first + " ");
    const study::FoundVolumes other(dicom::Scan{});
    EXPECT_EQ(seriesOfText(seriesText(*found, *box(0).series().stack), other).stack, nullptr)
        << "a list of another folder";
    for (const char* text : {"", "1", "a/b/c/d", "1/2/3/4"})
        EXPECT_EQ(seriesOfText(text, *found).stack, nullptr) << text;
    for (const dicom::Series& series : found->scan().studies.front().series)
        if (series.seriesInstanceUid != first && series.seriesInstanceUid != second) {
            dropOn(1, series.stacks.front());
            EXPECT_EQ(uidIn(1), series.seriesInstanceUid);
            EXPECT_EQ(&boxes().chosen(), &box(1));
        }
}

TEST_F(ImageBoxesTest, SlicesAsAcquiredScrollWithTheirPrior) {
    writeSlices("2.25.1", "2.25.11", "20200101", 21, 500.0, 2.0, "2.25.8");
    writeSlices("2.25.2", "2.25.21", "20240101", 41, -40.0, 1.0, "2.25.9");
    window_->open(folder_ / "2.25.21.1.dcm");
    ASSERT_TRUE(waitUntil([&] { return window_->hasStudy() && window_->hanging().isReady(); }));
    action("images-as-acquired").trigger();
    ASSERT_TRUE(waitForBoxes(1, 2));
    EXPECT_EQ(allUids(), "2.25.21 2.25.11 ");
    EXPECT_TRUE(boxes().isLinked());
    EXPECT_EQ(box(0).place(), 20u) << "the middle of 41";
    EXPECT_EQ(box(1).place(), 10u) << "the middle of 21";
    choose(0);
    box(0).setPlace(24);  // 4 mm up
    EXPECT_EQ(box(1).place(), 12u);
    choose(1);
    box(1).setPlace(5);  // 14 mm down
    EXPECT_EQ(box(0).place(), 10u);
    press(1, Qt::Key_L);
    EXPECT_FALSE(boxes().isLinked());
    box(1).setPlace(0);
    EXPECT_EQ(box(0).place(), 10u) << "alone";
    // The way back shows the panes, and what was arranged comes again.
    ASSERT_TRUE(waitUntil([&] { return areUpToDate(); }));
    press(1, Qt::Key_Escape);
    EXPECT_FALSE(images().isShown());
    EXPECT_TRUE(window_->panes().isVisible());
}

TEST_F(ImageBoxesTest, OneBoxAloneAndAllAgain) {
    for (int n = 1; n <= 2; ++n) writeFilm("XA", "2.25.1", "2.25.1" + std::to_string(n), "20240101", 100 * n);
    window_->open(folder_.path());
    ASSERT_TRUE(waitForBoxes(1, 1));
    boxes().setGrid(1, 2);
    ASSERT_TRUE(waitForBoxes(1, 2));
    choose(1);
    press(1, Qt::Key_B);
    EXPECT_TRUE(boxes().isAlone());
    EXPECT_FALSE(box(0).view().isVisible());
    EXPECT_TRUE(box(1).view().isVisible());
    press(1, Qt::Key_Escape);
    EXPECT_FALSE(boxes().isAlone());
    EXPECT_TRUE(box(0).view().isVisible());
    EXPECT_TRUE(images().isShown()) << "Esc first shows all boxes again";
}

TEST_F(ImageBoxesTest, MeasurementsAreUndoneInTheOrderOfTheirBoxes) {
    for (int n = 1; n <= 2; ++n) writeFilm("XA", "2.25.1", "2.25.1" + std::to_string(n), "20240101", 100 * n);
    window_->open(folder_.path());
    ASSERT_TRUE(waitForBoxes(1, 1));
    boxes().setGrid(1, 2);
    ASSERT_TRUE(waitForBoxes(1, 2));
    drawLineIn(0);
    drawLineIn(1);
    drawLineIn(0, 14.0);
    const auto counts = [&] {
        return std::pair(box(0).measuring().all().size(), box(1).measuring().all().size());
    };
    EXPECT_EQ(counts(), (std::pair<std::size_t, std::size_t>{2, 1}));
    action("undo").trigger();
    EXPECT_EQ(counts(), (std::pair<std::size_t, std::size_t>{1, 1}));
    action("undo").trigger();
    EXPECT_EQ(counts(), (std::pair<std::size_t, std::size_t>{1, 0}));
    action("redo").trigger();
    EXPECT_EQ(counts(), (std::pair<std::size_t, std::size_t>{1, 1}));
    // Into another box: what was drawn goes along.
    boxes().setGrid(1, 1);
    boxes().setGrid(1, 2);
    ASSERT_TRUE(waitForBoxes(1, 2));
    EXPECT_EQ(counts(), (std::pair<std::size_t, std::size_t>{1, 1}));
}

TEST_F(ImageBoxesTest, TwoBoxesOfOneSeriesShareMeasurements) {
    writeFilm("XA", "2.25.1", "2.25.11", "20240101", 100);
    window_->open(folder_.path());
    ASSERT_TRUE(waitForBoxes(1, 1));
    BoxArrangement twice = boxes().arrangement();
    twice.columns = 2;
    twice.boxes.push_back(twice.boxes.front());
    boxes().arrange(QStringLiteral("twice"), twice);
    ASSERT_TRUE(waitForBoxes(1, 2));
    drawLineIn(1);
    EXPECT_EQ(box(0).measuring().all().size(), 1u);
    action("undo").trigger();
    EXPECT_TRUE(box(0).measuring().all().empty());
    EXPECT_TRUE(box(1).measuring().all().empty());
}

TEST_F(ImageBoxesTest, AreKeptForTheStudyAndSavedAsAProtocol) {
    const dicom::test::TemporaryFolder store;
    for (int n = 1; n <= 3; ++n) writeFilm("XA", "2.25.1", "2.25.1" + std::to_string(n), "20240101", 100 * n);
    sessions_ = store.path();
    restart();
    window_->open(folder_.path());
    ASSERT_TRUE(waitForBoxes(1, 1));
    boxes().setGrid(3, 1);
    ASSERT_TRUE(waitForBoxes(3, 1));
    ASSERT_TRUE(waitUntil([&] { return window_->hanging().isReady(); }));
    const std::string before = allUids();
    window_->hanging().save(QStringLiteral("Tower"));
    ASSERT_EQ(window_->hanging().own().all().size(), 1u);
    restart();
    ASSERT_TRUE(waitUntil([&] { return window_->hanging().own().all().size() == 1u; }));
    window_->open(folder_.path());
    ASSERT_TRUE(waitForBoxes(3, 1));
    EXPECT_EQ(allUids(), before);
    EXPECT_EQ(window_->hanging().own().all().front().name, "Tower");
    boxes().setGrid(1, 1);
    ASSERT_TRUE(waitUntil([&] { return window_->hanging().isReady(); }));
    window_->hanging().hang(QStringLiteral("Tower"));
    ASSERT_TRUE(waitForBoxes(3, 1));
    EXPECT_EQ(allUids(), before);
}

TEST_F(ImageBoxesTest, GoIntoAWindowOfTheirOwnAndBack) {
    writeSlices("2.25.2", "2.25.21", "20240101", 21, 0.0, 1.0, "2.25.9");
    window_->open(folder_.path());
    ASSERT_TRUE(waitUntil([&] { return window_->hasStudy(); }));
    action("images-as-acquired").trigger();
    ASSERT_TRUE(waitUntil([&] { return areUpToDate(); }));
    images().setDetached(true);
    EXPECT_TRUE(window_->panes().isVisible());
    EXPECT_TRUE(images().view().isVisible());
    EXPECT_NE(images().view().window(), window_->panes().window());
    images().setPlace(3);
    ASSERT_TRUE(waitUntil([&] { return areUpToDate(); }));
    EXPECT_TRUE(action("save-view").isEnabled()) << "nothing hides the volume";
    images().setDetached(false);
    EXPECT_EQ(images().view().window(), window_->panes().window());
    EXPECT_FALSE(window_->panes().isVisible());
    EXPECT_EQ(images().place(), 3u);
}

TEST(KeptBoxes, AreReadAsTheyWereWritten) {
    study::KeptBoxes kept{.rows = 2, .columns = 3, .isLinked = true, .boxes = {}};
    kept.boxes = {std::nullopt, study::KeptBoxes::Box{std::string(64, 'a'), 1, 7}};
    EXPECT_EQ(study::keptBoxesOf(study::toJson(kept)), kept);
    for (const char* text : {"", "[]", "{}", "null", R"({"rows":0,"columns":1,"linked":true,"boxes":[]})",
                             R"({"rows":1,"columns":99,"linked":true,"boxes":[]})",
                             R"({"rows":1,"columns":1,"linked":1,"boxes":[]})",
                             R"({"rows":1,"columns":1,"linked":true,"boxes":[null,null]})",
                             R"({"rows":1e9,"columns":1,"linked":true,"boxes":[]})"})
        EXPECT_FALSE(study::keptBoxesOf(text)) << text;
    const auto odd = study::keptBoxesOf(
        R"({"rows":1,"columns":1,"linked":true,"boxes":[{"series":"x","stack":0,"place":0}]})");
    ASSERT_TRUE(odd);
    EXPECT_FALSE(odd->boxes.front());
}

}  // namespace
}  // namespace macula::viewer
