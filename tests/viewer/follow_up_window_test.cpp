// Lesions in two studies of a patient, measured one after the other in the window, and compared.
#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include <dcmtk/dcmdata/dcdeftag.h>
#include <dcmtk/dcmdata/dcitem.h>
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QTableWidget>
#include <QTemporaryDir>

#include "support.h"
#include "synthetic.h"
#include "viewer/browser/study_browser.h"
#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

class FollowUpWindowTest : public WindowTest {
  protected:
    void SetUp() override {
        sessions_ = (folder_ / "sessions").string();
        refusesRaw_ = false;
        write("2.25.71", "20260301", "SYNTHETIC^ONE", "1");
        write("2.25.72", "20250301", "SYNTHETIC^ONE", "2");
        write("2.25.73", "20240301", "SOMEBODY^ELSE", "3");
        WindowTest::SetUp();
    }
    void write(const std::string& uid, const std::string& date, const std::string& name,
               const std::string& suffix) {
        dicom::test::SyntheticSeries series;
        series.size = {16, 14, 12};
        series.studyUid = uid;
        series.seriesUid = uid + ".1";
        series.frameOfReferenceUid = uid + ".2";
        series.patientName = name;
        series.edits.push_back([date](DcmItem& dataset) {
            dataset.putAndInsertString(DCM_StudyDate, date.c_str());
            dataset.putAndInsertString(DCM_PatientBirthDate, "19600229");
            dataset.putAndInsertString(DCM_PatientSex, "F");
        });
        // Another value for each study: volumes are told apart by their voxels.
        series.ramp = series.rampOf().plus(10.0 * std::stod(suffix));
        auto slices = dicom::test::slicesOf(series);
        for (dicom::test::Slice& slice : slices) slice.sopInstanceUid += "." + suffix;
        dicom::test::writeFiles(folder_ / "all" / suffix, series, slices);
    }
    void openStudyOf(const std::string& uid) {
        auto* browser = window_->findChild<StudyBrowser*>();
        ASSERT_NE(browser, nullptr);
        if (browser->found() == nullptr) window_->open(folder_ / "all");
        ASSERT_TRUE(waitUntil([&] { return window_->hasStudy() && !window_->loading(); }));
        const auto& volumes = browser->found()->volumes();
        for (std::size_t i = 0; i < volumes.size(); ++i)
            if (volumes[i].series->studyInstanceUid == uid && now() != uid) Q_EMIT browser->chosen(i);
        ASSERT_TRUE(waitUntil([&] { return !window_->loading() && now() == uid; }));
    }
    std::string now() { return window_->session().study().identity.studyInstanceUid; }
    void measure(const std::string& label, double longMm, double shortMm) {
        window_->session().change(QStringLiteral("Lesion"), [&](scene::StudyState& next) {
            next.measurements.push_back(
                {.label = label,
                 .shape = slices::Bidirectional{.firstMm = {{{0, 0, 0}, {longMm, 0, 0}}},
                                                .secondMm = {{{1, 0, 0}, {1, shortMm, 0}}}}});
        });
    }
    QDialog* followUp() {
        window_->findChild<QAction*>(QStringLiteral("follow-up"))->trigger();
        QDialog* dialog = nullptr;
        EXPECT_TRUE(waitUntil([&] {
            dialog = window_->findChild<QDialog*>(QStringLiteral("follow-up-dialog"));
            return dialog != nullptr;
        }));
        return dialog;
    }
    static QString cell(const QDialog& dialog, int row, int column) {
        return dialog.findChild<QTableWidget*>()->item(row, column)->text();
    }

    const dicom::test::TemporaryFolder folder_;
};

TEST_F(FollowUpWindowTest, ComparesWhatIsKeptOfThePriorWithWhatIsOnScreen) {
    openStudyOf("2.25.73");
    measure("Liver", 900, 10);  // of another patient
    openStudyOf("2.25.72");
    measure("Liver", 50, 30);
    measure("Lung", 20, 10);
    openStudyOf("2.25.71");
    ASSERT_TRUE(window_->state().measurements.empty());
    measure("liver", 30, 20);
    QDialog* dialog = followUp();
    ASSERT_NE(dialog, nullptr);
    auto* table = dialog->findChild<QTableWidget*>();
    ASSERT_EQ(table->columnCount(), 2) << "not the other patient";
    EXPECT_EQ(table->horizontalHeaderItem(0)->text(), QStringLiteral("2025-03-01"));
    EXPECT_EQ(table->horizontalHeaderItem(1)->text(), QStringLiteral("2026-03-01"));
    ASSERT_EQ(table->rowCount(), 2 + 4);
    EXPECT_EQ(cell(*dialog, 0, 0), QStringLiteral("50.0"));
    EXPECT_EQ(cell(*dialog, 0, 1), QStringLiteral("30.0"));
    EXPECT_EQ(cell(*dialog, 1, 1), QStringLiteral("not measured"));
    EXPECT_EQ(cell(*dialog, 2, 0), QStringLiteral("70.0"));
    EXPECT_EQ(cell(*dialog, 2, 1), QStringLiteral("–"));
    EXPECT_TRUE(cell(*dialog, 5, 1).startsWith(QStringLiteral("NE")));

    // A person calls it gone.
    auto* gone = dialog->findChild<QAbstractButton*>(QStringLiteral("follow-up-gone"));
    table->setCurrentCell(0, 1);
    EXPECT_FALSE(gone->isEnabled()) << "it was measured";
    table->setCurrentCell(1, 1);
    ASSERT_TRUE(gone->isEnabled());
    gone->click();
    EXPECT_EQ(cell(*dialog, 1, 1), QStringLiteral("0 (gone)"));
    EXPECT_EQ(cell(*dialog, 2, 1), QStringLiteral("30.0"));
    EXPECT_EQ(cell(*dialog, 3, 1), QStringLiteral("-57.1 %"));
    EXPECT_TRUE(cell(*dialog, 5, 1).startsWith(QStringLiteral("PR")));

    // What is measured now changes the table at once.
    measure("Lung", 8, 4);
    EXPECT_EQ(cell(*dialog, 1, 1), QStringLiteral("8.0"));
    EXPECT_EQ(cell(*dialog, 2, 1), QStringLiteral("38.0"));
    dialog->findChild<QAbstractButton*>(QStringLiteral("follow-up-copy"))->click();
    EXPECT_TRUE(QGuiApplication::clipboard()->text().startsWith(QStringLiteral(
        "lesion,axis,at_baseline,20250301_mm,20260301_mm\r\nLiver,long,yes,50.000,30.000\r\n")));
    EXPECT_TRUE(dialog->findChild<QLabel*>(QStringLiteral("follow-up-notes"))
                    ->text()
                    .contains(QStringLiteral("New lesions")));
    // Another study is another table.
    openStudyOf("2.25.72");
    EXPECT_TRUE(waitUntil(
        [&] { return window_->findChild<QDialog*>(QStringLiteral("follow-up-dialog")) == nullptr; }));
}

}  // namespace
}  // namespace macula::viewer
