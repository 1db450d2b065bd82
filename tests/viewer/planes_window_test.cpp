// A batch of planes in the window: asked for in a pane, counted, written, and refused where it makes none.
#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

#include "dicom/support.h"
#include "dicom/synthetic.h"
#include "study/open/opened_study.h"
#include "viewer/output/planes_dialog.h"
#include "viewer/slices/slice_view.h"
#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

class PlanesWindowTest : public WindowTest {
  protected:
    PlanesWindowTest() { layout_ = scene::Layout::fourPanes; }

    void openCt() {
        series_.size = {16, 15, 14};
        dicom::test::writeFiles(folder_ / "ct", series_);
        window_->open(folder_ / "ct");
        ASSERT_TRUE(waitUntil([this] { return window_->hasStudy() && !window_->loading(); }));
        ASSERT_TRUE(waitUntil([this] { return coronal().isUpToDate() && coronal().shownFrame(); }));
    }
    SliceView& coronal() { return window_->slices(slices::Orientation::coronal); }
    PlanesDialog* dialog() { return window_->findChild<PlanesDialog*>(QStringLiteral("planes-dialog")); }
    QString sum() { return dialog()->findChild<QLabel*>(QStringLiteral("planes-sum"))->text(); }
    void setMm(const char* name, double mm) {
        dialog()->findChild<QDoubleSpinBox*>(QLatin1String(name))->setValue(mm);
    }
    QPushButton* ok() { return dialog()->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok); }

    dicom::test::TemporaryFolder folder_;
    dicom::test::SyntheticSeries series_;
};

TEST_F(PlanesWindowTest, PlanesOfAPaneBecomeASeries) {
    openCt();
    Q_EMIT coronal().savePlanesAsked();
    ASSERT_NE(dialog(), nullptr);
    setMm("planes-from", -2.0);
    setMm("planes-to", 2.0);
    setMm("planes-step", 1.0);
    EXPECT_TRUE(sum().startsWith(QStringLiteral("5 images of"))) << sum().toStdString();
    setMm("planes-step", 0.01);
    setMm("planes-to", 3000.0);
    EXPECT_FALSE(ok()->isEnabled()) << sum().toStdString();
    setMm("planes-to", 2.0);
    setMm("planes-step", 1.0);
    ok()->click();
    QFileDialog* files = nullptr;
    ASSERT_TRUE(waitUntil([&] {
        files = window_->findChild<QFileDialog*>();
        return files != nullptr;
    }));
    std::filesystem::create_directories(folder_ / "planes");
    const QString chosen = QString::fromStdString((folder_ / "planes").string());
    Q_EMIT files->fileSelected(chosen);
    files->close();
    ASSERT_TRUE(waitUntil([this] {
        return window_->message().contains(QStringLiteral("5 planes are written"));
    })) << window_->message().toStdString();
    Progress progress;
    const auto again = study::openStudy(folder_ / "planes", progress);
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(again->volume->size().z, 5);
    EXPECT_EQ(again->frameOfReferenceUid, window_->session().study().frameOfReferenceUid);
    const glm::dvec3 step = glm::dvec3(again->volume->worldFromVoxel()[2]);
    EXPECT_NEAR(glm::length(step), 1.0, 1e-4);
    EXPECT_NEAR(std::abs(glm::dot(step, coronal().shownFrame()->plane.normal())), 1.0, 1e-4)
        << "across the pane, which has the planes of the acquisition";
}

TEST_F(PlanesWindowTest, RadialPlanesAreCountedAndFilesWithoutAPatientSaySo) {
    window_->open(std::nullopt);  // the phantom is of nobody
    ASSERT_TRUE(waitUntil([this] { return window_->hasStudy() && coronal().shownFrame().has_value(); }));
    window_->findChild<QAction*>(QStringLiteral("save-plane-batch"))->trigger();
    ASSERT_NE(dialog(), nullptr);
    auto* withoutPatient = dialog()->findChild<QCheckBox*>(QStringLiteral("without-patient"));
    EXPECT_TRUE(withoutPatient->isChecked());
    EXPECT_FALSE(withoutPatient->isEnabled());
    auto* kind = dialog()->findChild<QComboBox*>(QStringLiteral("planes-kind"));
    EXPECT_EQ(kind->count(), 2) << "there is no curve";
    kind->setCurrentIndex(1);
    dialog()->findChild<QSpinBox*>(QStringLiteral("planes-count"))->setValue(7);
    EXPECT_TRUE(sum().startsWith(QStringLiteral("7 images of"))) << sum().toStdString();
    ASSERT_TRUE(dialog()->batch().radial);
    EXPECT_EQ(dialog()->batch().radial->count, 7);
    dialog()->reject();
    window_->session().change(QStringLiteral("Curve"), [](scene::StudyState& next) {
        next.slices.curveMm = {{-20, 0, -20}, {0, 5, 0}, {20, 0, 20}};
    });
    Q_EMIT coronal().savePlanesAsked();
    PlanesDialog* second = nullptr;
    for (PlanesDialog* each : window_->findChildren<PlanesDialog*>())
        if (each->isVisible()) second = each;
    ASSERT_NE(second, nullptr);
    EXPECT_EQ(second->findChild<QComboBox*>(QStringLiteral("planes-kind"))->count(), 3);
}

}  // namespace
}  // namespace macula::viewer
