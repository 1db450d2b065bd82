// Images that are no volumes, in the window: opened, stepped through, played, shown as a person wants.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QComboBox>
#include <QKeyEvent>
#include <QWheelEvent>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include "dicom/support.h"
#include "dicom/synthetic.h"
#include "viewer/browser/study_browser.h"
#include "viewer/panes/pane_grid.h"
#include "viewer/planar/planar_controller.h"
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

}  // namespace
}  // namespace macula::viewer
