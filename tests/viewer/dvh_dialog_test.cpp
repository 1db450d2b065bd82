// The chart of dose-volume histograms, and its figures.
#include "viewer/dose/dvh_dialog.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QImage>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QTableWidget>

#include "viewer/dose/dvh_chart.h"
#include "viewer/offscreen.h"

namespace macula::viewer {
namespace {

// A region in which doses from `low` to `high` Gy are equally frequent.
study::RegionInDose ramp(const char* name, double low, double high, std::array<std::uint8_t, 3> rgb) {
    std::vector<float> samples;
    for (int i = 0; i < 200; ++i) samples.push_back(float(low + (high - low) * (i + 0.5) / 200));
    study::RegionInDose region{.set = "Plan", .label = name, .rgb = rgb, .volumeMl = 12.5, .dose = {}};
    region.dose.voxels = region.dose.samples = samples.size();
    region.dose.histogram = study::DoseHistogram(samples);
    return region;
}

std::shared_ptr<const study::DoseReport> report() {
    study::DoseReport made{.unit = "Gy", .isInGy = true};
    made.reference = study::DoseReference{.value = 60.0, .of = study::DoseReference::Of::prescription};
    made.regions = {ramp("PTV", 55.0, 65.0, {255, 0, 0}), ramp("Cord", 0.0, 40.0, {0, 160, 0}),
                    study::RegionInDose{.set = "Plan", .label = "Empty", .dose = {}}};
    made.notes = {Text("A note.")};
    return std::make_shared<const study::DoseReport>(made);
}

class DvhDialogTest : public test::OffscreenTest {
  protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        dialog_.emplace();
        dialog_->show();
        dialog_->setReport(report(), QStringLiteral("Dose of a whole plan"));
        settle();
    }
    void TearDown() override {
        dialog_.reset();
        OffscreenTest::TearDown();
    }
    void pointAt(const QPointF& place) {
        QMouseEvent event(QEvent::MouseMove, place, dialog_->chart().mapToGlobal(place), Qt::NoButton,
                          Qt::NoButton, {});
        QApplication::sendEvent(&dialog_->chart(), &event);
    }
    std::optional<DvhDialog> dialog_;
};

TEST_F(DvhDialogTest, CurvesLieWhereTheirDosesAre) {
    DvhChart& chart = dialog_->chart();
    const QImage picture = chart.grab().toImage();
    const auto halfway = chart.placeOnCurve(1, 20.0);
    const auto quarter = chart.placeOnCurve(1, 30.0);
    const auto none = chart.placeOnCurve(1, 40.0);
    ASSERT_TRUE(halfway && quarter && none);
    EXPECT_NEAR(none->y() - quarter->y(), quarter->y() - halfway->y(), 0.5) << "a ramp is straight";
    const QColor at = picture.pixelColor(halfway->toPoint() * picture.devicePixelRatio());
    EXPECT_GT(at.green(), at.red() + 60);
    EXPECT_FALSE(chart.placeOnCurve(2, 10.0)) << "nothing of the region lies in the dose";
}

TEST_F(DvhDialogTest, ThePointerReadsTheNearestCurve) {
    DvhChart& chart = dialog_->chart();
    pointAt(*chart.placeOnCurve(1, 20.0));
    EXPECT_TRUE(chart.readText().startsWith("Cord: ")) << chart.readText().toStdString();
    EXPECT_TRUE(chart.readText().contains("% receive ")) << chart.readText().toStdString();
    pointAt(*chart.placeOnCurve(0, 60.0));
    EXPECT_TRUE(chart.readText().startsWith("PTV: ")) << chart.readText().toStdString();
    pointAt({1.0, 1.0});
    EXPECT_TRUE(chart.readText().isEmpty());
}

TEST_F(DvhDialogTest, FiguresAreThoseOfTheHistograms) {
    QTableWidget& table = dialog_->table();
    ASSERT_EQ(table.rowCount(), 3);
    const auto cell = [&](int row, const char* header) {
        for (int c = 0; c < table.columnCount(); ++c)
            if (table.horizontalHeaderItem(c)->text().startsWith(QString::fromLatin1(header)))
                return table.item(row, c)->text();
        return QString();
    };
    EXPECT_EQ(table.item(0, 0)->text(), "PTV");
    EXPECT_EQ(cell(0, "Mean"), "60.00");
    EXPECT_EQ(cell(0, "D50"), "60.00");
    EXPECT_EQ(cell(0, "D95"), "55.50");
    EXPECT_EQ(cell(0, "V95 %"), "80.0") << "57 Gy of 55 to 65";
    EXPECT_EQ(cell(1, "V20 Gy"), "50.0");
    EXPECT_EQ(cell(2, "Mean"), "–");
    EXPECT_EQ(dialog_->findChild<QLabel*>(QStringLiteral("dvh-notes"))->text(), "A note.");
}

TEST_F(DvhDialogTest, ACheckMarkHidesACurve) {
    dialog_->table().item(1, 0)->setCheckState(Qt::Unchecked);
    EXPECT_FALSE(dialog_->chart().placeOnCurve(1, 20.0));
    dialog_->table().item(1, 0)->setCheckState(Qt::Checked);
    EXPECT_TRUE(dialog_->chart().placeOnCurve(1, 20.0));
}

TEST_F(DvhDialogTest, CopiesAndExportsAllFigures) {
    dialog_->findChild<QPushButton*>(QStringLiteral("dvh-copy"))->click();
    const QString copied = QGuiApplication::clipboard()->text();
    EXPECT_TRUE(copied.startsWith("set,region,")) << copied.toStdString();
    EXPECT_TRUE(copied.contains(QStringLiteral("\nPlan,Cord,12.5,200"))) << copied.toStdString();
    QString exported;
    QObject::connect(&*dialog_, &DvhDialog::exportAsked, &*dialog_,
                     [&](const QString& csv) { exported = csv; });
    dialog_->findChild<QPushButton*>(QStringLiteral("dvh-export"))->click();
    EXPECT_EQ(exported.count(QLatin1Char('\n')), 4);
}

TEST_F(DvhDialogTest, WithoutAReportNothingCanBeCopied) {
    dialog_->setTrouble(QStringLiteral("There is no structure set."));
    EXPECT_FALSE(dialog_->findChild<QPushButton*>(QStringLiteral("dvh-copy"))->isEnabled());
    EXPECT_EQ(dialog_->table().rowCount(), 0);
    EXPECT_FALSE(dialog_->chart().placeOnCurve(0, 60.0));
    dialog_->begin(QStringLiteral("Computing"));
    bool isCancelled = false;
    QObject::connect(&*dialog_, &DvhDialog::cancelAsked, &*dialog_, [&] { isCancelled = true; });
    for (QPushButton* button : dialog_->findChildren<QPushButton*>())
        if (button->text().contains(QStringLiteral("Cancel"))) button->click();
    EXPECT_TRUE(isCancelled);
}

}  // namespace
}  // namespace macula::viewer
