// Images that are no volumes, in the window: opened, stepped through, played, shown as a person wants.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QKeyEvent>
#include <QWheelEvent>
#include <algorithm>
#include <array>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include "dicom/support.h"
#include "dicom/synthetic.h"
#include "dicom/synthetic_softcopy.h"
#include "viewer/browser/study_browser.h"
#include "viewer/panes/pane_grid.h"
#include "viewer/planar/planar_controller.h"
#include "viewer/planar/planar_measuring.h"
#include "viewer/planar/planar_presenting.h"
#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

using dicom::test::put;

class PlanarWindowTest : public WindowTest {
  protected:
    PlanarWindowTest() { refusesRaw_ = false; }

    // A DX of 30 x 20 pixels, brighter to the right, of which low values are bright.
    static dicom::test::SyntheticSeries radiograph() {
        dicom::test::SyntheticSeries series;
        series.modality = "DX";
        series.sopClassUid = UID_DigitalXRayImageStorageForPresentation;
        series.patientName = "RADIOGRAPH^ANNA";
        series.size = {30, 20, 1};
        series.intercept = 0.0;
        series.rawInstead = [](const dicom::test::Slice&, int i, int) { return 100 * i; };
        series.edits.push_back([](DcmItem& item) {
            item.findAndDeleteElement(DCM_ImagePositionPatient);
            item.findAndDeleteElement(DCM_ImageOrientationPatient);
            item.findAndDeleteElement(DCM_PixelSpacing);
            put(item, DCM_PhotometricInterpretation, "MONOCHROME1");
            put(item, DCM_PatientOrientation, "L\\F");
            put(item, DCM_WindowCenter, "1450");
            put(item, DCM_WindowWidth, "2901");
            put(item, DCM_ImagerPixelSpacing, "0.2\\0.2");
            put(item, DCM_EstimatedRadiographicMagnificationFactor, "1.25");
        });
        return series;
    }
    PlanarController& images() { return window_->images(); }
    bool waitForImage() {
        return waitUntil([this] { return images().isShown() && images().isUpToDate(); });
    }
    int greyAt(int x, int y) { return qGray(images().view().picture().pixel(x, y)); }
    void press(int key) {
        QKeyEvent event(QEvent::KeyPress, key, Qt::NoModifier);
        QApplication::sendEvent(&images().view(), &event);
    }
    void click(const char* name) {
        auto* button = images().widget().findChild<QAbstractButton*>(QLatin1String(name));
        ASSERT_NE(button, nullptr) << name;
        button->click();
    }
    // A drag of the left button from one pixel of the image to another.
    void drag(QPointF from, QPointF to) {
        PlanarView& view = images().view();
        const auto send = [&](QEvent::Type type, QPointF pixel, Qt::MouseButtons held) {
            const QPointF at = view.paneFromPicture().map(pixel);
            const Qt::MouseButton button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
            QMouseEvent event(type, at, view.mapToGlobal(at), button, held, Qt::NoModifier);
            QApplication::sendEvent(&view, &event);
        };
        send(QEvent::MouseButtonPress, from, Qt::LeftButton);
        send(QEvent::MouseMove, 0.5 * (from + to), Qt::LeftButton);
        send(QEvent::MouseMove, to, Qt::LeftButton);
        send(QEvent::MouseButtonRelease, to, Qt::NoButton);
    }
    QAction& action(const char* name) {
        auto* found = window_->findChild<QAction*>(QLatin1String(name));
        EXPECT_NE(found, nullptr) << name;
        return *found;
    }
    const std::vector<study::ImageMeasurement>& measured() { return images().measuring().all(); }
    QString textOf(std::size_t index) { return images().measuring().textOf(measured().at(index)); }
    void openRadiograph() {
        dicom::test::writeFiles(folder_.path(), radiograph());
        window_->open(folder_.path());
        ASSERT_TRUE(waitForImage());
    }
    dicom::test::TemporaryFolder folder_;
};

TEST_F(PlanarWindowTest, AFolderWithoutAVolumeShowsItsImages) {
    dicom::test::writeFiles(folder_.path(), radiograph());
    window_->open(folder_.path());
    ASSERT_TRUE(waitForImage());
    EXPECT_TRUE(window_->message().isEmpty()) << window_->message().toStdString();
    EXPECT_FALSE(window_->panes().isVisible());
    EXPECT_TRUE(window_->windowTitle().contains(QStringLiteral("RADIOGRAPH"), Qt::CaseInsensitive));
    EXPECT_EQ(window_->fidelity(), QStringLiteral("Images, not in 3D"));
    EXPECT_GT(greyAt(0, 0), 250) << "MONOCHROME1: low is bright";
    EXPECT_LT(greyAt(29, 0), 5);
    const PlanarLabels& labels = images().view().labels();
    EXPECT_TRUE(labels.identity.join(QLatin1Char(' ')).contains(QStringLiteral("ANNA"), Qt::CaseInsensitive));
    EXPECT_EQ(edgeLetters(labels.towards, {}),
              (std::array<QString, 4>{QStringLiteral("R"), QStringLiteral("H"), QStringLiteral("L"),
                                      QStringLiteral("F")}));
    EXPECT_TRUE(labels.warnings.join(QLatin1Char(' ')).contains(QStringLiteral("magnification of 1.25")));
    EXPECT_DOUBLE_EQ(labels.mmPerPixel, 0.16);
}

TEST_F(PlanarWindowTest, AnImageThatIsOpenedItselfIsShownBesideVolumes) {
    const auto files = dicom::test::writeFiles(folder_.path(), radiograph());
    dicom::test::SyntheticSeries volume;
    volume.patientName = "RADIOGRAPH^ANNA";
    volume.seriesUid = "2.25.7001";
    dicom::test::writeFiles(folder_ / "volume", volume);
    std::filesystem::copy_file(files.front(), folder_ / "volume" / "radiograph.dcm");
    window_->open(folder_ / "volume" / "radiograph.dcm");
    ASSERT_TRUE(waitForImage());
    EXPECT_TRUE(window_->message().isEmpty()) << window_->message().toStdString();
    EXPECT_FALSE(window_->panes().isVisible());
}

TEST_F(PlanarWindowTest, TurningMirroringAndInvertingAreSaidAndUndone) {
    dicom::test::writeFiles(folder_.path(), radiograph());
    window_->open(folder_.path());
    ASSERT_TRUE(waitForImage());
    const auto said = [this] { return images().view().labels().warnings.join(QLatin1Char(' ')); };
    press(Qt::Key_R);
    EXPECT_TRUE(said().contains(QStringLiteral("turned by 90")));
    EXPECT_EQ(edgeLetters(images().view().labels().towards, images().view().turn())[1], QStringLiteral("R"))
        << "a quarter clockwise brings the left edge to the top";
    press(Qt::Key_M);
    EXPECT_TRUE(said().contains(QStringLiteral("mirrored")));
    press(Qt::Key_M);
    for (int i = 0; i < 3; ++i) click("turn-image");
    EXPECT_EQ(images().view().turn(), PlanarTurn());
    EXPECT_FALSE(said().contains(QStringLiteral("turned")));
    press(Qt::Key_I);
    EXPECT_TRUE(said().contains(QStringLiteral("inverted")));
    EXPECT_LT(greyAt(0, 0), 5);
    click("invert-image");
    EXPECT_GT(greyAt(0, 0), 250);
}

TEST_F(PlanarWindowTest, AWindowIsDraggedAndTheFilesComesBack) {
    dicom::test::writeFiles(folder_.path(), radiograph());
    window_->open(folder_.path());
    ASSERT_TRUE(waitForImage());
    const double width = images().display().window.width;
    Q_EMIT images().view().windowDragged({images().view().width() * 0.25, 0.0});
    EXPECT_NEAR(images().display().window.width, 2.0 * width, 1e-6 * width);
    auto* windows = images().widget().findChild<QComboBox*>(QStringLiteral("images-window"));
    ASSERT_NE(windows, nullptr);
    EXPECT_EQ(windows->currentIndex(), -1);
    Q_EMIT windows->activated(0);
    EXPECT_EQ(images().display().window.width, width);
}

TEST_F(PlanarWindowTest, FramesPlayInALoopAtTheirOwnTimes) {
    dicom::test::SyntheticSeries series = radiograph();
    series.size = {30, 20, 4};
    series.modality = "US";
    series.sopClassUid = UID_UltrasoundMultiframeImageStorage;
    dicom::test::MultiFrame file;
    file.functionalGroups = false;
    file.dimensions = false;
    file.edits.push_back([](DcmItem& item) { put(item, DCM_FrameTime, "20"); });
    dicom::test::writeMultiFrame(folder_ / "loop.dcm", series, dicom::test::slicesOf(series), file);
    window_->open(folder_.path());
    ASSERT_TRUE(waitForImage());
    ASSERT_EQ(images().stack()->frames.size(), 4u);
    std::set<std::size_t> seen;
    int steps = 0;
    QObject::connect(&images(), &PlanarController::imageShown, &images(), [&] {
        seen.insert(images().place());
        ++steps;
    });
    press(Qt::Key_Space);
    EXPECT_TRUE(images().isPlaying());
    EXPECT_TRUE(waitUntil([&] { return steps > 9; }));
    EXPECT_EQ(seen.size(), 4u);
    press(Qt::Key_Space);
    EXPECT_FALSE(images().isPlaying());
    press(Qt::Key_Home);
    EXPECT_EQ(images().place(), 0u);
    press(Qt::Key_Down);
    EXPECT_EQ(images().place(), 1u);
    press(Qt::Key_End);
    press(Qt::Key_Down);
    EXPECT_EQ(images().place(), 3u) << "no farther than the last";
}

TEST_F(PlanarWindowTest, ALoopWithoutAWindowKeepsThatOfItsFirstFrame) {
    dicom::test::SyntheticSeries series = radiograph();
    series.size = {30, 20, 3};
    series.sopClassUid = UID_UltrasoundMultiframeImageStorage;
    series.rawInstead = [](const dicom::test::Slice& slice, int i, int) {
        return 100 * i + 1000 * slice.place;
    };
    dicom::test::MultiFrame file;
    file.functionalGroups = false;
    file.dimensions = false;
    file.edits.push_back([](DcmItem& item) {
        item.findAndDeleteElement(DCM_WindowCenter);
        item.findAndDeleteElement(DCM_WindowWidth);
    });
    dicom::test::writeMultiFrame(folder_ / "loop.dcm", series, dicom::test::slicesOf(series), file);
    window_->open(folder_.path());
    ASSERT_TRUE(waitForImage());
    const study::PlanarDisplay first = images().display();
    press(Qt::Key_End);
    ASSERT_TRUE(waitForImage());
    ASSERT_EQ(images().place(), 2u);
    EXPECT_EQ(images().display(), first) << "brightness would flicker";
}

TEST_F(PlanarWindowTest, NamesAreHiddenEverywhere) {
    dicom::test::writeFiles(folder_.path(), radiograph());
    window_->open(folder_.path());
    ASSERT_TRUE(waitForImage());
    images().showNames(false);
    EXPECT_TRUE(images().view().labels().identity.isEmpty());
}

TEST_F(PlanarWindowTest, AVolumeBesideImagesIsComeBackTo) {
    dicom::test::SyntheticSeries volume;
    volume.patientName = "VOLUME^BEN";
    volume.patientId = "V1";
    volume.studyUid = "2.25.500";
    volume.seriesUid = "2.25.501";
    dicom::test::writeFiles(folder_ / "volume", volume);
    dicom::test::SyntheticSeries image = radiograph();
    image.studyUid = "2.25.600";
    image.seriesUid = "2.25.601";
    dicom::test::writeFiles(folder_ / "image", image);
    window_->open(folder_.path());
    ASSERT_TRUE(waitUntil([this] { return window_->hasStudy(); }));
    EXPECT_FALSE(images().isShown());
    auto* browser = window_->findChild<StudyBrowser*>();
    ASSERT_NE(browser, nullptr);
    const auto all = study::planarSeriesOf(*browser->found());
    ASSERT_EQ(all.size(), 1u);
    Q_EMIT browser->imagesChosen(all[0].stack);
    ASSERT_TRUE(waitForImage());
    EXPECT_TRUE(window_->windowTitle().contains(QStringLiteral("RADIOGRAPH"), Qt::CaseInsensitive));
    EXPECT_FALSE(window_->windowTitle().contains(QStringLiteral("VOLUME"), Qt::CaseInsensitive));
    press(Qt::Key_Escape);
    EXPECT_FALSE(images().isShown());
    EXPECT_TRUE(window_->panes().isVisible());
    EXPECT_TRUE(window_->windowTitle().contains(QStringLiteral("VOLUME"), Qt::CaseInsensitive));
}

TEST_F(PlanarWindowTest, ADistanceIsDrawnMovedRemovedAndUndone) {
    openRadiograph();
    press(Qt::Key_D);
    drag({5, 10}, {15, 10});
    ASSERT_EQ(measured().size(), 1u);
    EXPECT_NEAR(measured()[0].points[1].x, 15.0, 1e-6);
    EXPECT_EQ(textOf(0), QStringLiteral("1.6 mm, at the object by magnification 1.25"));
    drag({15, 10}, {25, 10});
    ASSERT_EQ(measured().size(), 1u) << "its end was moved";
    EXPECT_EQ(textOf(0).left(6), QStringLiteral("3.2 mm"));
    EXPECT_EQ(action("undo").isEnabled(), true);
    action("undo").trigger();
    EXPECT_EQ(textOf(0).left(6), QStringLiteral("1.6 mm"));
    action("undo").trigger();
    EXPECT_TRUE(measured().empty());
    EXPECT_FALSE(action("undo").isEnabled());
    action("redo").trigger();
    action("redo").trigger();
    ASSERT_EQ(measured().size(), 1u);
    EXPECT_EQ(textOf(0).left(6), QStringLiteral("3.2 mm"));
    drag({10, 10}, {10, 12});  // by its line: it is chosen, and moved as a whole
    EXPECT_NEAR(measured()[0].points[0].y, 12.0, 1e-6);
    EXPECT_NEAR(measured()[0].points[1].y, 12.0, 1e-6);
    press(Qt::Key_Delete);
    EXPECT_TRUE(measured().empty());
    action("undo").trigger();
    EXPECT_EQ(measured().size(), 1u);
}

TEST_F(PlanarWindowTest, AnglesEllipsesAndCobbAnglesAreDrawn) {
    openRadiograph();
    press(Qt::Key_E);
    drag({10, 5}, {20, 15});
    ASSERT_EQ(measured().size(), 1u);
    // Values are 100 for each column: the mean is that of the middle, between columns 14 and 15.
    EXPECT_TRUE(textOf(0).startsWith(QStringLiteral("1450 ± "))) << textOf(0).toStdString();
    press(Qt::Key_C);
    drag({2, 2}, {12, 2});
    drag({2, 18}, {12, 8});
    ASSERT_EQ(measured().size(), 2u);
    EXPECT_EQ(textOf(1), QStringLiteral("45.0°"));
    press(Qt::Key_G);
    drag({28, 2}, {22, 2});
    EXPECT_EQ(measured().size(), 2u) << "the second leg is missing";
    press(Qt::Key_Escape);
    EXPECT_TRUE(images().measuring().tool()) << "it ends the drawing alone";
    drag({28, 2}, {22, 2});
    drag({22, 8}, {22, 8});
    ASSERT_EQ(measured().size(), 3u);
    EXPECT_EQ(textOf(2), QStringLiteral("90.0°"));
    action("copy-image-measurements").trigger();
    EXPECT_EQ(QApplication::clipboard()->text().count(QLatin1Char('\n')), 2);
    press(Qt::Key_Escape);
    EXPECT_FALSE(images().measuring().tool());
}

TEST_F(PlanarWindowTest, WhatIsMeasuredBelongsToItsFrame) {
    dicom::test::SyntheticSeries series = radiograph();
    series.size = {30, 20, 3};
    series.sopClassUid = UID_UltrasoundMultiframeImageStorage;
    dicom::test::MultiFrame file;
    file.functionalGroups = false;
    file.dimensions = false;
    dicom::test::writeMultiFrame(folder_ / "loop.dcm", series, dicom::test::slicesOf(series), file);
    window_->open(folder_.path());
    ASSERT_TRUE(waitForImage());
    press(Qt::Key_Down);
    ASSERT_TRUE(waitForImage());
    press(Qt::Key_D);
    drag({5, 10}, {15, 10});
    ASSERT_EQ(measured().size(), 1u);
    EXPECT_EQ(measured()[0].frame, 1);
    EXPECT_FALSE(images().measuring().textsOfFrame().isEmpty());
    press(Qt::Key_Up);
    ASSERT_TRUE(waitForImage());
    EXPECT_TRUE(images().measuring().textsOfFrame().isEmpty());
    drag({15, 10}, {25, 10});
    EXPECT_EQ(measured().size(), 2u) << "the other frame's has no handle here";
}

TEST_F(PlanarWindowTest, ActionsOfTheVolumeAreDisabledAndSayWhy) {
    openRadiograph();
    for (const char* name : {"send-to-archive", "save-presentation", "save-movie", "save-model"}) {
        EXPECT_FALSE(action(name).isEnabled()) << name;
        EXPECT_FALSE(action(name).toolTip().isEmpty()) << name;
    }
    EXPECT_TRUE(action("save-picture").isEnabled()) << "it saves the image";
    EXPECT_TRUE(action("save-measurements").isEnabled());
}

TEST_F(PlanarWindowTest, ThePictureToSaveHasNoNames) {
    openRadiograph();
    const QImage picture = images().view().pictureWithoutNames();
    EXPECT_NE(images().view().grab().toImage().convertToFormat(QImage::Format_RGB888), picture);
    images().showNames(false);
    EXPECT_EQ(images().view().pictureWithoutNames(), picture);
}

TEST_F(PlanarWindowTest, ShuttersAndOverlaysAreShownAndOverlaysHidden) {
    dicom::test::SyntheticSeries series = radiograph();
    series.edits.push_back([](DcmItem& item) {
        put(item, DCM_ShutterShape, "RECTANGULAR");
        put(item, DCM_ShutterLeftVerticalEdge, "3");
        put(item, DCM_ShutterRightVerticalEdge, "28");
        put(item, DCM_ShutterUpperHorizontalEdge, "3");
        put(item, DCM_ShutterLowerHorizontalEdge, "18");
        item.putAndInsertUint16(DcmTag(0x6000, 0x0010, EVR_US), 1);
        item.putAndInsertUint16(DcmTag(0x6000, 0x0011, EVR_US), 16);
        const std::array<Sint16, 2> origin{10, 10};
        item.putAndInsertSint16Array(DcmTag(0x6000, 0x0050, EVR_SS), origin.data(), 2);
        item.putAndInsertUint16(DcmTag(0x6000, 0x0100, EVR_US), 1);
        item.putAndInsertUint16(DcmTag(0x6000, 0x0102, EVR_US), 0);
        const std::array<Uint16, 1> bits{0xffff};
        item.putAndInsertUint16Array(DcmTag(0x6000, 0x3000, EVR_OW), bits.data(), 1);
    });
    dicom::test::writeFiles(folder_.path(), series);
    window_->open(folder_.path());
    ASSERT_TRUE(waitForImage());
    EXPECT_EQ(greyAt(0, 0), 0) << "it would be bright";
    EXPECT_EQ(greyAt(1, 5), 0);
    EXPECT_GT(greyAt(2, 5), 200);
    EXPECT_EQ(greyAt(20, 9), 255);
    EXPECT_LT(greyAt(20, 10), 200);
    press(Qt::Key_O);
    EXPECT_LT(greyAt(20, 9), 200);
    const auto said = [this] { return images().view().labels().warnings.join(QLatin1Char(' ')); };
    EXPECT_TRUE(said().contains(QStringLiteral("overlays are hidden")));
    EXPECT_TRUE(said().contains(QStringLiteral("shutter")));
}

TEST_F(PlanarWindowTest, APresentationStateIsChosenAndTakenAwayAgain) {
    const auto files = dicom::test::writeFiles(folder_.path(), radiograph());
    std::string uid;
    dicom::test::editFile(files.at(0), [&](DcmItem& item) {
        OFString value;
        item.findAndGetOFString(DCM_SOPInstanceUID, value);
        uid = value.c_str();
    });
    dicom::test::SyntheticSoftcopy state{.patientName = "RADIOGRAPH^ANNA", .imageUids = {uid}};
    state.rescale = std::pair(1.0, 0.0);
    state.window = std::pair(1400.0, 2900.0);
    state.rotationDeg = 90;
    state.isFlipped = true;
    state.area = std::array{1, 1, 10, 20};
    state.label = "NIGHT";
    state.edits.push_back([](DcmItem& item) {
        DcmItem& annotation = dicom::test::nested(item, DCM_GraphicAnnotationSequence);
        put(annotation, DCM_GraphicLayer, "ONE");
        DcmItem& graphic = dicom::test::nested(annotation, DCM_GraphicObjectSequence);
        put(graphic, DCM_GraphicAnnotationUnits, "PIXEL");
        put(graphic, DCM_GraphicType, "POLYLINE");
        const std::array<Float32, 4> line{2, 10, 8, 10};
        graphic.putAndInsertFloat32Array(DCM_GraphicData, line.data(), 4);
    });
    dicom::test::writeSoftcopy(folder_ / "state.dcm", state);
    window_->open(folder_.path());
    ASSERT_TRUE(waitForImage());
    auto* list = images().widget().findChild<QComboBox*>(QStringLiteral("images-presentation"));
    ASSERT_NE(list, nullptr);
    ASSERT_EQ(list->count(), 2);
    EXPECT_TRUE(list->itemText(1).contains(QStringLiteral("NIGHT")));
    const QImage before = images().view().pictureWithoutNames();
    const study::PlanarDisplay stored = images().display();
    list->setCurrentIndex(1);
    Q_EMIT list->activated(1);
    ASSERT_TRUE(waitUntil([this] { return images().presenting().state() != nullptr; }));
    EXPECT_EQ(images().display().window.center, 1400.0);
    EXPECT_EQ(images().view().turn(), (PlanarTurn{1, true}));
    EXPECT_LT(greyAt(0, 0), 5) << "its polarity takes the place of MONOCHROME1";
    // The line is drawn where its pixels are, which are dark.
    const QImage with = images().view().pictureWithoutNames();
    int brightest = 0;
    for (double y = 8.9; y <= 10.1; y += 0.02) {
        const QPoint at = images().view().paneFromPicture().map(QPointF(4.5, y)).toPoint();
        if (with.rect().contains(at)) brightest = std::max(brightest, qGray(with.pixel(at)));
    }
    EXPECT_GT(brightest, 150);
    EXPECT_LT(greyAt(5, 10), 60);
    Q_EMIT list->activated(0);
    EXPECT_EQ(images().display(), stored);
    EXPECT_EQ(images().view().turn(), PlanarTurn());
    EXPECT_EQ(images().view().pictureWithoutNames(), before);
}

class KeptImagesTest : public PlanarWindowTest {
  protected:
    KeptImagesTest() { sessions_ = store_.path(); }
    dicom::test::TemporaryFolder store_;
};

TEST_F(KeptImagesTest, HowImagesWereLeftIsThereAgain) {
    openRadiograph();
    press(Qt::Key_R);
    press(Qt::Key_D);
    drag({5, 10}, {15, 10});
    ASSERT_EQ(measured().size(), 1u);
    Q_EMIT images().view().windowDragged({images().view().width() * 0.25, 0.0});
    const study::PlanarDisplay left = images().display();
    window_.reset();
    makeWindow();
    window_->open(folder_.path());
    ASSERT_TRUE(waitForImage());
    ASSERT_TRUE(waitUntil([this] { return !measured().empty(); }));
    EXPECT_EQ(textOf(0).left(6), QStringLiteral("1.6 mm"));
    EXPECT_EQ(images().display(), left);
    EXPECT_EQ(images().view().turn().quarters, 1);
    EXPECT_FALSE(action("undo").isEnabled());
    action("remove-image-measurements").trigger();
    EXPECT_TRUE(measured().empty());
    window_.reset();
    makeWindow();
    window_->open(folder_.path());
    ASSERT_TRUE(waitForImage());
    ASSERT_TRUE(waitUntil([this] { return images().view().turn().quarters == 1; }));
    EXPECT_TRUE(measured().empty());
}

}  // namespace
}  // namespace macula::viewer
