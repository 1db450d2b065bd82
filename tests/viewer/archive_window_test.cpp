// A person searches an archive, which really runs, and opens a study from it.
#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>
#include <QTreeView>

#include "net/servers.h"
#include "net/sources/source_list.h"
#include "study/spool/spool.h"
#include "synthetic.h"
#include "viewer/archive/source_dialog.h"
#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

namespace fs = std::filesystem;

class ArchiveWindowTest : public WindowTest {
  protected:
    ArchiveWindowTest() {
        series_.size = {16, 14, 12};
        dicom::test::writeFiles(folder_.path(), series_);
        net::test::sendFolder(folder_.path(), archive_.dicomPort(), archive_.title());
        fs::remove_all(userDataFolder() / "fetched");
    }

    net::Source byDimse() const {
        net::Source source;
        source.name = "Hospital";
        source.peer =
            net::DimsePeer{.host = "127.0.0.1", .port = archive_.dicomPort(), .calledAe = archive_.title()};
        return source;
    }
    net::Source byWeb() const {
        net::Source source;
        source.name = "Hospital";
        net::WebPeer peer;
        peer.url = archive_.webUrl();
        source.peer = peer;
        return source;
    }
    static void setUp(const net::Source& source) {
        auto list = net::SourceList::read(net::SourceFiles::ofUser());
        ASSERT_TRUE(list);
        const auto put = list->put(source);
        ASSERT_TRUE(put) << put.error().message;
    }
    template <class Widget>
    Widget& named(const char* name) {
        auto* found = window_->findChild<Widget*>(QString::fromLatin1(name));
        EXPECT_NE(found, nullptr) << name;
        return *found;
    }
    void openPanel() {
        for (QAction* action : window_->findChildren<QAction*>()) {
            if (action->shortcut() == QKeySequence(QStringLiteral("Ctrl+Shift+A"))) action->trigger();
        }
    }
    void searchFor(const char* patient) {
        QTest::keyClicks(&named<QLineEdit>("archive-patient"), QString::fromLatin1(patient));
        QTest::keyClick(&named<QLineEdit>("archive-patient"), Qt::Key_Return);
    }
    int rows() { return named<QTreeView>("archive-studies").model()->rowCount(); }
    QString remark() { return named<QLabel>("archive-remark").text(); }

    void findAndOpen() {
        openPanel();
        searchFor("synth");
        ASSERT_TRUE(waitUntil([&] { return rows() == 1; })) << remark().toStdString();
        QTest::keyClick(&named<QTreeView>("archive-studies"), Qt::Key_Return);
        const QString told = QStringLiteral("12 images fetched");
        ASSERT_TRUE(
            waitUntil([&] { return remark() == told || remark().contains(QStringLiteral("archive")); }));
        ASSERT_EQ(remark(), told) << remark().toStdString() << window_->message().toStdString();
        const QString size = QStringLiteral("16×14×12");
        ASSERT_TRUE(waitUntil([&] { return !window_->loading() && window_->voxels().contains(size); }))
            << window_->voxels().toStdString() << window_->message().toStdString();
        EXPECT_TRUE(window_->message().isEmpty()) << window_->message().toStdString();
    }
    void expectWhole() {
        const auto spool = study::Spool::open();
        ASSERT_TRUE(spool);
        ASSERT_EQ(spool->entries().size(), 1u);
        EXPECT_TRUE(spool->entries().front().record.isComplete);
        EXPECT_EQ(spool->entries().front().record.source, "Hospital");
        EXPECT_EQ(spool->entries().front().instances, 12u);
    }

    dicom::test::SyntheticSeries series_;
    dicom::test::TemporaryFolder folder_;
    net::test::Orthanc archive_;
};

TEST_F(ArchiveWindowTest, AStudyIsFoundAndOpenedByDimse) {
    setUp(byDimse());
    findAndOpen();
    expectWhole();
}

TEST_F(ArchiveWindowTest, AStudyIsFoundAndOpenedByDicomWeb) {
    setUp(byWeb());
    findAndOpen();
    expectWhole();
}

TEST_F(ArchiveWindowTest, SeriesOfAFoundStudyShowHowTheyLookBeforeAnythingIsFetched) {
    setUp(byWeb());
    openPanel();
    searchFor("synth");
    auto& series = named<QListWidget>("archive-series");
    ASSERT_TRUE(waitUntil([&] { return series.count() == 1 && !series.item(0)->icon().isNull(); }))
        << remark().toStdString() << archive_.output();
    EXPECT_TRUE(series.isVisible());
    EXPECT_TRUE(series.item(0)->text().contains(QStringLiteral("12 images")))
        << series.item(0)->text().toStdString();
    const auto spool = study::Spool::open();
    ASSERT_TRUE(spool);
    EXPECT_TRUE(spool->entries().empty());
    EXPECT_FALSE(window_->hasStudy());
}

TEST_F(ArchiveWindowTest, ArchivesOfDimseShowNoSeries) {
    setUp(byDimse());
    findAndOpen();
    EXPECT_FALSE(named<QListWidget>("archive-series").isVisible());
}

TEST_F(ArchiveWindowTest, NothingThatMatchesAndNobodyWhoAnswersAreSaid) {
    setUp(byDimse());
    openPanel();
    searchFor("NOBODY");
    EXPECT_TRUE(waitUntil([&] { return remark() == QStringLiteral("No study matches."); }))
        << remark().toStdString();
    archive_.stop();
    QTest::keyClick(&named<QLineEdit>("archive-patient"), Qt::Key_Return);
    EXPECT_TRUE(waitUntil([&] {
        return named<QPushButton>("archive-search").text() == QStringLiteral("Search") && rows() == 0 &&
               !remark().contains(QStringLiteral("matches"));
    })) << remark().toStdString();
    EXPECT_FALSE(remark().contains(QStringLiteral("Searching")));
}

TEST_F(ArchiveWindowTest, ADayThatIsNoneIsNotSearchedFor) {
    setUp(byDimse());
    openPanel();
    QTest::keyClicks(&named<QLineEdit>("archive-from"), QStringLiteral("31.11.2026"));
    QTest::keyClick(&named<QLineEdit>("archive-from"), Qt::Key_Return);
    EXPECT_TRUE(remark().contains(QStringLiteral("2026-11-30"))) << remark().toStdString();
}

TEST_F(ArchiveWindowTest, AnArchiveIsSetUpTriedAndRemoved) {
    auto list = net::SourceList::read(net::SourceFiles::ofUser());
    ASSERT_TRUE(list);
    for (const net::Source& each : std::vector(list->all())) ASSERT_TRUE(list->remove(each.name));
    SourceDialog dialog(*list);
    dialog.show();
    const auto type = [&](const char* name, const QString& text) {
        auto* field = dialog.findChild<QLineEdit*>(QString::fromLatin1(name));
        ASSERT_NE(field, nullptr) << name;
        field->clear();
        QTest::keyClicks(field, text);
    };
    const auto press = [&](const char* name) {
        dialog.findChild<QPushButton*>(QString::fromLatin1(name))->click();
    };
    auto* told = dialog.findChild<QLabel*>(QStringLiteral("source-remark"));
    type("source-name", QStringLiteral("Clinic"));
    press("source-save");
    EXPECT_FALSE(told->text().isEmpty()) << "no host";
    EXPECT_TRUE(list->all().empty());

    type("source-host", QStringLiteral("127.0.0.1"));
    type("source-called", QString::fromStdString(archive_.title()));
    dialog.findChild<QSpinBox*>(QStringLiteral("source-port"))->setValue(archive_.dicomPort());
    press("source-test");
    EXPECT_TRUE(waitUntil([&] { return told->text().contains(QStringLiteral("✓")); }))
        << told->text().toStdString();
    EXPECT_FALSE(told->text().contains(QStringLiteral("✗"))) << told->text().toStdString();
    press("source-save");
    ASSERT_EQ(list->all().size(), 1u) << told->text().toStdString();
    EXPECT_EQ(list->all().front().name, "Clinic");
    press("source-remove");
    EXPECT_TRUE(list->all().empty()) << told->text().toStdString();
}

}  // namespace
}  // namespace macula::viewer
