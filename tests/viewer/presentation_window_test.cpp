// Presentation states of the list of studies, in the real window: their series is opened, and shown so.
#include "viewer/window_fixture.h"

#include <QTest>
#include <QTreeView>
#include <functional>

#include "scene/presentation/presentation_file.h"
#include "study/open/found_volumes.h"
#include "support.h"
#include "synthetic_softcopy.h"
#include "viewer/browser/study_browser.h"
#include "viewer/slices/slice_view.h"

namespace macula::viewer {
namespace {

class PresentationWindowTest : public WindowTest {
  protected:
    PresentationWindowTest() { layout_ = scene::Layout::fourPanes; }
    void SetUp() override {
        WindowTest::SetUp();
        if (!window_) return;
        slices_ = dicom::test::slicesOf(series_);
        dicom::test::writeFiles(folder_ / "images", series_, slices_);
    }

    // A 3D view of the series from the left, as an object in its study.
    void write3dView() {
        const auto scanned = dicom::test::scan(folder_ / "images");
        ASSERT_TRUE(scanned);
        const dicom::Series& series = scanned->studies.at(0).series.at(0);
        scene::PresentationRequest request;
        request.volume = dicom::test::load(series);
        request.images = *scene::presentedImages(series, series.stacks.at(0));
        request.state.preset = scene::builtInCatalogue()->presets.at(2);  // not the usual one
        request.state.camera = frameBox(request.volume->worldBox(), ViewDirection::left, 30.0, 1.0);
        const auto written = scene::writePresentation(folder_ / "images" / "view.dcm", request);
        ASSERT_TRUE(written.ok()) << written.error().message;
        camera_ = *request.state.camera;
    }
    QTreeView* tree() { return window_->findChild<QTreeView*>(QStringLiteral("studies")); }
    QModelIndex rowThatBegins(const QString& title) {
        const std::function<QModelIndex(const QModelIndex&)> find = [&](const QModelIndex& parent) {
            for (int n = 0; n < tree()->model()->rowCount(parent); ++n) {
                const QModelIndex index = tree()->model()->index(n, 0, parent);
                if (index.data().toString().startsWith(title)) return index;
                if (const QModelIndex below = find(index); below.isValid()) return below;
            }
            return QModelIndex();
        };
        return find({});
    }
    // With keys alone, once the folder is read.
    void openRow(const QString& title) {
        pressKey(Qt::Key_F2);
        ASSERT_TRUE(waitUntil([&] { return rowThatBegins(title).isValid(); })) << title.toStdString();
        ASSERT_TRUE(tree()->isVisible());
        tree()->setFocus();
        tree()->setCurrentIndex(rowThatBegins(title));
        QTest::keyClick(tree(), Qt::Key_Return);
    }

    const dicom::test::TemporaryFolder folder_;
    dicom::test::SyntheticSeries series_;
    std::vector<dicom::test::Slice> slices_;
    Camera camera_;
};

TEST_F(PresentationWindowTest, A3dViewIsShownFromWhereItWasSaved) {
    write3dView();
    window_->open(folder_ / "images");
    ASSERT_TRUE(waitUntil([&] { return window_->hasStudy(); }));
    openRow(QStringLiteral("3D view"));
    const auto isThere = [&] {
        const auto camera = window_->state().camera;
        return camera && glm::length(camera->positionMm - camera_.positionMm) < 1.0;
    };
    EXPECT_TRUE(waitUntil(isThere)) << window_->message().toStdString();
    EXPECT_TRUE(waitUntil([&] { return window_->session().canUndo(); }));
}

// The series is not on screen yet: it is opened, and then shown so.
TEST_F(PresentationWindowTest, AViewOfSlicesOpensItsSeriesAndSetsItsWindow) {
    dicom::test::SyntheticSoftcopy said;
    said.imageUids = {slices_[5].sopInstanceUid};
    said.area = {2, 3, 5, 4};
    dicom::test::writeSoftcopy(folder_ / "images" / "slices.dcm", said);
    dicom::test::SyntheticSeries other;
    other.seriesUid = "2.25.1701";
    other.size.z = 20;  // it is larger, and so it is opened first
    other.ramp = dicom::test::Ramp{.value = 2000.0, .perMm = glm::dvec3(0.5)};
    dicom::test::writeFiles(folder_ / "images" / "other", other);
    window_->open(folder_ / "images");
    ASSERT_TRUE(waitUntil([&] { return window_->hasStudy(); }));
    const std::string before = window_->session().study().seriesDigest;
    openRow(QStringLiteral("View of slices"));
    ASSERT_TRUE(waitUntil([&] { return window_->session().state().slices.window.has_value(); }))
        << window_->message().toStdString();
    EXPECT_NE(window_->session().study().seriesDigest, before);
    EXPECT_EQ(window_->session().state().slices.window->center, -600.0);
    EXPECT_TRUE(window_->session().state().slices.asAcquired);
    // Of 8 columns four are seen, so the pane shows less than the volume.
    SliceView& pane = window_->slices(slices::acquiredOrientation(*window_->session().study().volume));
    ASSERT_TRUE(waitUntil([&] { return pane.shownFrame() && pane.isUpToDate(); }));
    const double seenMm = pane.shownFrame()->mmPerPixel * pane.shownFrame()->sizePx.x;
    pane.fit();
    ASSERT_TRUE(waitUntil([&] { return pane.isUpToDate(); }));
    EXPECT_LT(seenMm, 0.9 * pane.shownFrame()->mmPerPixel * pane.shownFrame()->sizePx.x);
}

TEST_F(PresentationWindowTest, OfASeriesThatIsNotThereASentenceSaysSo) {
    dicom::test::SyntheticSoftcopy said;
    said.imageUids = {"2.25.99"};
    said.referencedSeriesUid = "2.25.98";
    dicom::test::writeSoftcopy(folder_ / "images" / "lost.dcm", said);
    window_->open(folder_ / "images");
    ASSERT_TRUE(waitUntil([&] { return window_->hasStudy(); }));
    openRow(QStringLiteral("View of slices"));
    ASSERT_TRUE(waitUntil([&] { return !window_->message().isEmpty(); }));
    EXPECT_TRUE(window_->message().contains(QStringLiteral("not in this folder")))
        << window_->message().toStdString();
    EXPECT_FALSE(window_->session().canUndo()) << "nothing was changed";
}

}  // namespace
}  // namespace macula::viewer
