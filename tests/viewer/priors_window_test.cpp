// A person opens a study from an archive, which really runs, and compares it with an earlier one.
#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include <dcmtk/dcmdata/dcdeftag.h>
#include <dcmtk/dcmdata/dcitem.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QTreeView>

#include "net/servers.h"
#include "net/sources/source_list.h"
#include "study/spool/spool.h"
#include "synthetic.h"
#include "viewer/archive/found_study_list.h"
#include "viewer/second/second_volume_loader.h"
#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

namespace fs = std::filesystem;

class PriorsWindowTest : public WindowTest {
  protected:
    PriorsWindowTest() {
        fs::remove_all(userDataFolder() / "fetched");
        write("2.25.61", "20260301", "SYNTHETIC^ONE", "1");
        write("2.25.62", "20250301", "SYNTHETIC^ONE", "2");
        write("2.25.63", "20240301", "SOMEBODY^ELSE", "3");
        net::test::sendFolder(folder_.path(), archive_.dicomPort(), archive_.title());
        net::Source source;
        source.name = "Hospital";
        source.peer =
            net::DimsePeer{.host = "127.0.0.1", .port = archive_.dicomPort(), .calledAe = archive_.title()};
        auto list = net::SourceList::read(net::SourceFiles::ofUser());
        EXPECT_TRUE(list);
        for (const net::Source& each : std::vector(list->all())) EXPECT_TRUE(list->remove(each.name));
        EXPECT_TRUE(list->put(source));
    }
    // All with one ID, as when an ID was given twice.
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
        auto slices = dicom::test::slicesOf(series);
        for (dicom::test::Slice& slice : slices) slice.sopInstanceUid += "." + suffix;
        dicom::test::writeFiles(folder_ / suffix, series, slices);
    }
    template <class Object>
    Object& named(const char* name) {
        auto* found = window_->findChild<Object*>(QString::fromLatin1(name));
        EXPECT_NE(found, nullptr) << name;
        return *found;
    }
    int rows(const char* name) { return named<QTreeView>(name).model()->rowCount(); }
    QString remark(const char* name) { return named<QLabel>(name).text(); }
    void searchFor(const char* patient) {
        for (QAction* action : window_->findChildren<QAction*>()) {
            if (action->shortcut() == QKeySequence(QStringLiteral("Ctrl+Shift+A"))) action->trigger();
        }
        QTest::keyClicks(&named<QLineEdit>("archive-patient"), QString::fromLatin1(patient));
        QTest::keyClick(&named<QLineEdit>("archive-patient"), Qt::Key_Return);
    }
    void openLatest() {
        searchFor("synth");
        ASSERT_TRUE(waitUntil([&] { return rows("archive-studies") == 2; }))
            << remark("archive-remark").toStdString();
        QTest::keyClick(&named<QTreeView>("archive-studies"), Qt::Key_Return);
        ASSERT_TRUE(waitUntil([&] {
            return !window_->loading() && window_->voxels().contains(QStringLiteral("16×14×12"));
        })) << window_->message().toStdString();
        ASSERT_TRUE(waitUntil([&] { return rows("archive-priors") == 1; }))
            << remark("archive-priors-remark").toStdString();
    }
    QString cell(const char* list, int column) {
        return named<QTreeView>(list).model()->index(0, column).data().toString();
    }

    dicom::test::TemporaryFolder folder_;
    net::test::Orthanc archive_;
};

TEST_F(PriorsWindowTest, TheEarlierStudyIsListedFetchedAndShownBeside) {
    openLatest();
    EXPECT_TRUE(named<QWidget>("archive-priors").isVisible());
    EXPECT_EQ(cell("archive-priors", FoundStudyModel::date), QStringLiteral("2025-03-01"));
    EXPECT_EQ(cell("archive-priors", FoundStudyModel::place), QStringLiteral("Hospital"));
    ASSERT_TRUE(named<QPushButton>("archive-priors-beside").isEnabled());
    named<QPushButton>("archive-priors-beside").click();
    SecondVolumeLoader& loader = window_->secondVolume();
    ASSERT_TRUE(waitUntil([&] { return loader.second() != nullptr; }))
        << remark("archive-remark").toStdString() << window_->message().toStdString();
    EXPECT_EQ(loader.second()->study.identity.studyInstanceUid, "2.25.62");
    EXPECT_TRUE(waitUntil([&] {
        return cell("archive-priors", FoundStudyModel::place) == QStringLiteral("Hospital, fetched");
    })) << cell("archive-priors", FoundStudyModel::place).toStdString();
    EXPECT_FALSE(named<QPushButton>("archive-priors-fetch").isEnabled()) << "it is here";
}

TEST_F(PriorsWindowTest, AStudyIsFetchedInTheBackgroundAndLaterOpenedWithoutTheArchive) {
    searchFor("synth");
    ASSERT_TRUE(waitUntil([&] { return rows("archive-studies") == 2; }));
    named<QPushButton>("archive-studies-fetch").click();
    ASSERT_TRUE(waitUntil([&] {
        return remark("archive-remark").contains(QStringLiteral("12 images fetched"));
    })) << remark("archive-remark").toStdString();
    EXPECT_FALSE(window_->loading()) << "nobody asked to see it";
    archive_.stop();
    QTest::keyClick(&named<QLineEdit>("archive-patient"), Qt::Key_Return);
    ASSERT_TRUE(waitUntil([&] { return named<QPushButton>("archive-search").text() == "Search"; }));
    EXPECT_TRUE(remark("archive-remark").contains(QStringLiteral("Hospital:"))) << "it says nothing of it";
    ASSERT_EQ(rows("archive-studies"), 1);
    EXPECT_EQ(cell("archive-studies", FoundStudyModel::place), QStringLiteral("this machine"));
    QTest::keyClick(&named<QTreeView>("archive-studies"), Qt::Key_Return);
    EXPECT_TRUE(waitUntil([&] {
        return !window_->loading() && window_->voxels().contains(QStringLiteral("16×14×12"));
    })) << window_->message().toStdString();
}

TEST_F(PriorsWindowTest, ColumnsAreChosenAndNamesHidden) {
    auto& view = named<QTreeView>("archive-studies");
    searchFor("synth");
    ASSERT_TRUE(waitUntil([&] { return rows("archive-studies") == 2; }));
    EXPECT_TRUE(cell("archive-studies", FoundStudyModel::patient).contains(QStringLiteral("SYNTHETIC")));
    named<QAction>("names").trigger();
    EXPECT_FALSE(cell("archive-studies", FoundStudyModel::patient).contains(QStringLiteral("SYNTHETIC")));
    QAction* modalities = nullptr;
    for (QAction* action : view.header()->actions()) {
        if (action->text() == QStringLiteral("Modalities")) modalities = action;
    }
    ASSERT_NE(modalities, nullptr);
    modalities->trigger();
    EXPECT_TRUE(view.isColumnHidden(FoundStudyModel::modalities));
    auto* list = qobject_cast<FoundStudyList*>(view.parentWidget());
    ASSERT_NE(list, nullptr);
    const QString kept = list->columns();
    modalities->trigger();
    EXPECT_FALSE(view.isColumnHidden(FoundStudyModel::modalities));
    list->setColumns(kept);
    EXPECT_TRUE(view.isColumnHidden(FoundStudyModel::modalities));
}

}  // namespace
}  // namespace macula::viewer
