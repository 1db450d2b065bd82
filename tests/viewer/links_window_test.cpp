// A person follows a link, opens a manifest, and hears of a study in a folder that is watched.
#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>
#include <QTreeView>
#include <fstream>

#include "net/servers.h"
#include "net/sources/source_list.h"
#include "study/spool/spool.h"
#include "synthetic_manifest.h"
#include "viewer/links/link_choice.h"
#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

namespace fs = std::filesystem;

class LinksWindowTest : public WindowTest {
  protected:
    LinksWindowTest() {
        series_.size = {16, 14, 12};
        fs::remove_all(userDataFolder() / "fetched");
    }
    void SetUp() override {
        WindowTest::SetUp();
        if (IsSkipped()) return;
        auto list = net::SourceList::read(net::SourceFiles::ofUser());
        ASSERT_TRUE(list);
        for (const net::Source& each : std::vector(list->all())) ASSERT_TRUE(list->remove(each.name));
    }
    void setUpArchive() {
        dicom::test::writeFiles(folder_ / "study", series_);
        archive_.emplace();
        net::test::sendFolder(folder_ / "study", archive_->dicomPort(), archive_->title());
        net::Source source;
        source.name = "Hospital";
        net::WebPeer peer;
        peer.url = archive_->webUrl();
        source.peer = peer;
        auto list = net::SourceList::read(net::SourceFiles::ofUser());
        ASSERT_TRUE(list);
        const auto put = list->put(source);
        ASSERT_TRUE(put) << put.error().message;
    }
    void sendSecondStudy() {
        series_.studyUid = "2.25.2000";
        series_.seriesUid = "2.25.2001";
        std::vector<dicom::test::Slice> slices = dicom::test::slicesOf(series_);
        for (auto& slice : slices) slice.sopInstanceUid += ".2";
        dicom::test::writeFiles(folder_ / "other", series_, slices);
        net::test::sendFolder(folder_ / "other", archive_->dicomPort(), archive_->title());
    }
    QMessageBox* question() { return window_->findChild<QMessageBox*>(QStringLiteral("link-question")); }
    void press(const char* name) {
        auto* button = window_->findChild<QPushButton*>(QString::fromLatin1(name));
        ASSERT_NE(button, nullptr) << name;
        QTest::mouseClick(button, Qt::LeftButton);
    }
    bool waitUntilShown() {
        const QString size = QStringLiteral("16×14×12");
        return waitUntil([&] { return !window_->loading() && window_->voxels().contains(size); });
    }
    std::size_t fetchedStudies() {
        const auto spool = study::Spool::open();
        return spool ? spool->entries().size() : 99;
    }
    std::string told() { return window_->message().toStdString() + window_->voxels().toStdString(); }

    dicom::test::SyntheticSeries series_;
    dicom::test::TemporaryFolder folder_;
    std::optional<net::test::Orthanc> archive_;
};

TEST_F(LinksWindowTest, ALinkIsFollowedAfterAQuestionOnly) {
    setUpArchive();
    window_->openLink(QStringLiteral("macula://open?patient=SYN1"));
    ASSERT_NE(question(), nullptr);
    const QString asked = question()->text();
    EXPECT_TRUE(asked.contains(QStringLiteral("Hospital")) && asked.contains(QStringLiteral("SYN1")))
        << asked.toStdString();
    EXPECT_FALSE(window_->windowTitle().contains(QStringLiteral("SYN1")));
    EXPECT_EQ(question()->textFormat(), Qt::PlainText);
    EXPECT_EQ(question()->defaultButton(), question()->button(QMessageBox::Cancel))
        << "Enter fetches nothing";
    QTest::keyClick(question(), Qt::Key_Escape);
    ASSERT_TRUE(waitUntil([&] { return question() == nullptr; }));
    EXPECT_EQ(fetchedStudies(), 0u);

    window_->openLink(QStringLiteral("macula://open?study=%1").arg(QString::fromStdString(series_.studyUid)));
    ASSERT_NE(question(), nullptr);
    press("link-fetch");
    ASSERT_TRUE(waitUntilShown()) << told();
    EXPECT_EQ(fetchedStudies(), 1u);
}

TEST_F(LinksWindowTest, OneQuestionAtATime) {
    setUpArchive();
    window_->openLink(QStringLiteral("macula://open?accession=1"));
    const QString first = question()->text();
    window_->openLink(QStringLiteral("macula://open?accession=2"));
    EXPECT_EQ(window_->findChildren<QMessageBox*>(QStringLiteral("link-question")).size(), 1);
    EXPECT_EQ(question()->text(), first);
    EXPECT_TRUE(window_->message().contains(QStringLiteral("Another link"))) << told();
}

TEST_F(LinksWindowTest, IdsAreHiddenWithTheNames) {
    setUpArchive();
    window_->findChild<QAction*>(QStringLiteral("names"))->trigger();
    window_->openLink(QStringLiteral("macula://open?patient=SYN1&issuer=CLINIC"));
    ASSERT_NE(question(), nullptr);
    EXPECT_FALSE(question()->text().contains(QStringLiteral("SYN1"))) << question()->text().toStdString();
    EXPECT_FALSE(question()->text().contains(QStringLiteral("CLINIC")));
}

TEST_F(LinksWindowTest, BadLinksAndArchivesWithoutTheStudyAreSaid) {
    window_->openLink(QStringLiteral("macula://open?study=1.2"));
    EXPECT_TRUE(window_->message().contains(QStringLiteral("No archive has been set up"))) << told();
    setUpArchive();
    window_->openLink(QStringLiteral("macula://open?file=/etc/passwd"));
    EXPECT_EQ(question(), nullptr);
    EXPECT_TRUE(window_->message().contains(QStringLiteral("Part 1 of the link"))) << told();
    window_->openLink(QStringLiteral("macula://open?study=1.2.3"));
    press("link-fetch");
    ASSERT_TRUE(waitUntil([&] {
        return window_->message().contains(QStringLiteral("no study that fits the link"));
    })) << told();
}

TEST_F(LinksWindowTest, SeveralStudiesAreListedAndOneIsChosen) {
    setUpArchive();
    sendSecondStudy();
    window_->openLink(QStringLiteral("macula://open?patient=SYN1"));
    press("link-fetch");
    const auto choice = [&] { return window_->findChild<LinkChoice*>(); };
    ASSERT_TRUE(waitUntil([&] { return choice() != nullptr; })) << told();
    auto* list = choice()->findChild<QTreeView*>(QStringLiteral("link-studies"));
    EXPECT_EQ(list->model()->rowCount(), 2);
    EXPECT_EQ(fetchedStudies(), 0u);
    QTest::keyClick(list, Qt::Key_Return);
    ASSERT_TRUE(waitUntilShown()) << told();
    EXPECT_EQ(fetchedStudies(), 1u);
}

TEST_F(LinksWindowTest, AManifestOpensItsStudyAndSaysWhatNeverCame) {
    setUpArchive();
    dicom::test::SyntheticManifest manifest = dicom::test::manifestOf(series_);
    manifest.series[0].url = archive_->webUrl();
    manifest.series[0].instanceUids.push_back("2.25.999");
    dicom::test::writeManifest(folder_ / "manifest.dcm", manifest);
    window_->open(folder_ / "manifest.dcm");
    ASSERT_TRUE(waitUntilShown()) << told();
    EXPECT_TRUE(waitUntil([&] {
        return window_->message().contains(QStringLiteral("1 of 13 images that the manifest names"));
    })) << told();
    EXPECT_TRUE(window_->notes().contains(QStringLiteral("not known to be complete")))
        << window_->notes().toStdString();
}

TEST_F(LinksWindowTest, AManifestOfAStrangersAddressIsNotFollowed) {
    dicom::test::SyntheticManifest manifest = dicom::test::manifestOf(series_);
    manifest.series[0].url = "https://pacs.example.org/rs/studies/" + series_.studyUid;
    dicom::test::writeManifest(folder_ / "manifest.dcm", manifest);
    window_->open(folder_ / "manifest.dcm");
    EXPECT_TRUE(waitUntil([&] {
        return window_->message().contains(QStringLiteral("https://pacs.example.org/rs"));
    })) << told();
}

}  // namespace

class WatchWindowTest : public WindowTest {
  protected:
    WatchWindowTest() {
        settings_.watchedFolders = {QString::fromStdString(folder_.path().string())};
        watchPace_ = {.every = std::chrono::milliseconds(20), .quiet = std::chrono::milliseconds(200)};
        series_.size = {16, 14, 12};
    }
    QString arrived() {
        auto* label = window_->findChild<QLabel*>(QStringLiteral("arrival-text"));
        return label->isVisible() ? label->text() : QString();
    }

    dicom::test::SyntheticSeries series_;
    dicom::test::TemporaryFolder folder_;
};

TEST_F(WatchWindowTest, AStudyThatArrivesIsToldAndOpenedOnRequestOnly) {
    auto* watch = window_->findChild<WatchController*>();
    ASSERT_TRUE(waitUntil([&] { return watch->looks() > 0; }));
    dicom::test::writeFiles(folder_ / "new", series_);
    ASSERT_TRUE(waitUntil([&] { return !arrived().isEmpty(); }));
    EXPECT_TRUE(arrived().contains(QStringLiteral("CT, 12 images, SYNTHETIC, ONE")))
        << arrived().toStdString();
    EXPECT_FALSE(window_->hasStudy());
    window_->findChild<QAction*>(QStringLiteral("names"))->trigger();
    EXPECT_FALSE(arrived().contains(QStringLiteral("SYNTHETIC"))) << arrived().toStdString();
    QTest::mouseClick(window_->findChild<QPushButton*>(QStringLiteral("arrival-open")), Qt::LeftButton);
    const QString size = QStringLiteral("16×14×12");
    EXPECT_TRUE(waitUntil([&] { return !window_->loading() && window_->voxels().contains(size); }));
    EXPECT_TRUE(arrived().isEmpty());
}

}  // namespace macula::viewer
