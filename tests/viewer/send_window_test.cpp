// A person sends what Macula makes to an archive, which really runs, and what waits for it.
#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>

#include "base/sha256.h"
#include "net/connect.h"
#include "net/servers.h"
#include "net/sources/source_list.h"
#include "study/outbox/outbox.h"
#include "study/spool/spool.h"
#include "synthetic.h"
#include "synthetic_segmentation.h"
#include "viewer/archive/queue_dialog.h"
#include "viewer/archive/send_controller.h"
#include "viewer/archive/send_dialog.h"
#include "viewer/archive/waiting_bar.h"
#include "viewer/segmentation/segmentations_controller.h"
#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

namespace fs = std::filesystem;

class SendWindowTest : public WindowTest {
  protected:
    SendWindowTest() {
        series_.size = {16, 14, 12};
        files_ = dicom::test::writeFiles(folder_.path(), series_);
        fs::remove_all(study::outboxFolder());
        auto list = net::SourceList::read(net::SourceFiles::ofUser());
        EXPECT_TRUE(list && list->put(source()));
    }
    ~SendWindowTest() override { fs::remove_all(study::outboxFolder()); }

    net::Source source() const {
        net::Source source;
        source.name = "Hospital";
        source.peer =
            net::DimsePeer{.host = "127.0.0.1", .port = archive_.dicomPort(), .calledAe = archive_.title()};
        return source;
    }
    void openStudy() {
        Settings quick = window_->settings();
        quick.quality = QStringLiteral("draft");
        window_->takeSettings(quick);
        window_->open(folder_.path());
        ASSERT_TRUE(waitUntil([&] { return window_->hasStudy() && !window_->loading(); }));
    }
    void trigger(const char* action) { window_->findChild<QAction*>(QLatin1String(action))->trigger(); }
    SendDialog& dialog() { return *window_->findChild<SendDialog*>(); }
    WaitingBar& bar() { return *window_->findChild<WaitingBar*>(); }
    template <class Widget>
    static Widget& in(QWidget& parent, const char* name) {
        auto* found = parent.findChild<Widget*>(QLatin1String(name));
        EXPECT_NE(found, nullptr) << name;
        return *found;
    }
    static QString said(QWidget& parent, const char* name) { return in<QLabel>(parent, name).text(); }
    static void press(QWidget& parent, const char* name) { in<QPushButton>(parent, name).click(); }
    bool comes(const QString& message) {
        return waitUntil([&] { return window_->message().contains(message); });
    }
    // How many objects the archive has of the study, in series other than that of the images.
    std::size_t storedObjects() {
        Progress progress;
        auto archive = *net::archiveOf(source(), {});
        const auto found = archive->findInstances(series_.studyUid, {}, progress);
        EXPECT_TRUE(found);
        return found ? std::size_t(std::ranges::count_if(
                           *found,
                           [&](const auto& each) { return each.seriesInstanceUid != series_.seriesUid; }))
                     : 0;
    }
    std::size_t waitingEntries() { return study::Outbox::open()->entries().size(); }
    void sendPictureAndView() {
        trigger("send-to-archive");
        in<QCheckBox>(dialog(), "send-view").setChecked(true);
        press(dialog(), "send-now");
    }

    dicom::test::SyntheticSeries series_;
    dicom::test::TemporaryFolder folder_;
    std::vector<fs::path> files_;
    net::test::Orthanc archive_;
};

TEST_F(SendWindowTest, PictureAndViewGoToTheArchiveOfThePatientWhoIsNamed) {
    openStudy();
    trigger("send-to-archive");
    EXPECT_EQ(in<QComboBox>(dialog(), "send-archive").currentText(), QStringLiteral("Hospital"));
    const QString patients = said(dialog(), "send-patients");
    for (const char* part : {"SYNTHETIC, ONE", "SYN1"})
        EXPECT_TRUE(patients.contains(QLatin1String(part))) << patients.toStdString();
    EXPECT_TRUE(said(dialog(), "send-question").startsWith(QStringLiteral("Send 1 object")));
    in<QCheckBox>(dialog(), "send-view").setChecked(true);
    EXPECT_EQ(said(dialog(), "send-question"), QStringLiteral("Send 2 objects to Hospital, of:"));
    press(dialog(), "send-now");
    ASSERT_TRUE(comes(QStringLiteral("2 objects are stored in Hospital.")))
        << window_->message().toStdString();
    EXPECT_EQ(storedObjects(), 2u);
    EXPECT_EQ(waitingEntries(), 0u);
    EXPECT_EQ(window_->settings().archive, QStringLiteral("Hospital"));
}

TEST_F(SendWindowTest, MeasurementsGoAsAReportThatTheArchiveFindsAgain) {
    openStudy();
    trigger("send-to-archive");
    auto& none = in<QCheckBox>(dialog(), "send-measurements");
    EXPECT_FALSE(none.isEnabled());
    EXPECT_EQ(none.toolTip().section(QLatin1Char('\n'), 0, 0).left(30),
              QStringLiteral("There are no measurements to s"));
    dialog().reject();
    ASSERT_TRUE(waitUntil([&] { return window_->findChild<SendDialog*>() == nullptr; }));

    const dicom::test::Slice slice = dicom::test::slicesOf(series_)[4];
    window_->session().change(QStringLiteral("Measured"), [&](scene::StudyState& next) {
        next.measurements = {
            {.label = "Läsion",
             .shape = slices::Distance{{slice.positionMm, slice.positionMm + 9.0 * slice.rowDirection}}},
            {.shape = slices::Distance{{slice.positionMm, slice.positionMm + 30.0 * slice.normal()}}}};
    });
    trigger("send-to-archive");
    auto& box = in<QCheckBox>(dialog(), "send-measurements");
    ASSERT_TRUE(box.isEnabled());
    EXPECT_TRUE(box.text().contains(QStringLiteral("(2,"))) << box.text().toStdString();
    EXPECT_FALSE(box.isChecked()) << "sent unless somebody asks for it";
    in<QCheckBox>(dialog(), "send-picture").setChecked(false);
    EXPECT_FALSE(in<QPushButton>(dialog(), "send-now").isEnabled());
    box.setChecked(true);
    EXPECT_TRUE(said(dialog(), "send-patients").contains(QStringLiteral("SYN1")));
    press(dialog(), "send-now");
    ASSERT_TRUE(comes(QStringLiteral("1 object"))) << window_->message().toStdString();
    EXPECT_EQ(storedObjects(), 1u);
    Progress progress;
    const auto series = (*net::archiveOf(source(), {}))->findSeries(series_.studyUid, progress);
    ASSERT_TRUE(series);
    ASSERT_EQ(series->size(), 1u);
    EXPECT_EQ(series->at(0).modality, "SR");
}

TEST_F(SendWindowTest, SegmentsThatAreShownGoAsOneObject) {
    dicom::test::SyntheticSegmentation drawn;
    drawn.size = series_.size;
    drawn.worldFromVoxel = series_.expectedAffine();
    const glm::dvec3 middle = transformPoint(drawn.worldFromVoxel, 0.5 * glm::dvec3(series_.size));
    drawn.parts = {
        {.share = [=](const glm::dvec3& mm) { return glm::distance(mm, middle) < 6.0 ? 1.0 : 0.0; }}};
    dicom::test::writeSegmentation(folder_.path() / "seg.dcm", drawn);
    openStudy();
    trigger("send-to-archive");
    EXPECT_FALSE(in<QCheckBox>(dialog(), "send-segmentation").isEnabled()) << "it is not shown";
    dialog().reject();
    ASSERT_TRUE(waitUntil([&] { return window_->findChild<SendDialog*>() == nullptr; }));
    window_->session().change(QStringLiteral("Shown"), [&](scene::StudyState& next) {
        scene::choose(next.segmentations, {.digest = sha256Hex(drawn.sopInstanceUid), .isShown = true});
    });
    auto* segments = window_->findChild<SegmentationsController*>();
    ASSERT_NE(segments, nullptr);
    ASSERT_TRUE(waitUntil([&] { return segments->onScreen().ok(); }));
    trigger("send-to-archive");
    in<QCheckBox>(dialog(), "send-picture").setChecked(false);
    auto& box = in<QCheckBox>(dialog(), "send-segmentation");
    ASSERT_TRUE(box.isEnabled());
    EXPECT_FALSE(box.isChecked()) << "sent unless somebody asks for it";
    box.setChecked(true);
    press(dialog(), "send-now");
    ASSERT_TRUE(comes(QStringLiteral("1 object"))) << window_->message().toStdString();
    Progress progress;
    const auto series = (*net::archiveOf(source(), {}))->findSeries(series_.studyUid, progress);
    ASSERT_TRUE(series);
    ASSERT_EQ(series->size(), 1u);
    EXPECT_EQ(series->at(0).modality, "SEG");
}

TEST_F(SendWindowTest, WithoutPatientNothingOfThePatientGoes) {
    openStudy();
    trigger("send-to-archive");
    in<QCheckBox>(dialog(), "send-without-patient").setChecked(true);
    EXPECT_FALSE(said(dialog(), "send-patients").contains(QStringLiteral("SYN")));
    press(dialog(), "send-now");
    ASSERT_TRUE(comes(QStringLiteral("1 object"))) << window_->message().toStdString();
    Progress progress;
    const auto found = (*net::archiveOf(source(), {}))->findStudies({}, progress);
    ASSERT_TRUE(found);
    ASSERT_EQ(found->studies.size(), 1u);
    EXPECT_EQ(found->studies[0].patientName.find("SYN"), std::string::npos);
    EXPECT_NE(found->studies[0].studyInstanceUid, series_.studyUid);
}

TEST_F(SendWindowTest, FilesOfADiskAreNamedByTheirPatients) {
    dicom::test::SyntheticSeries other;
    other.patientName = "SYNTHETIC^TWO";
    other.patientId = "SYN2";
    other.studyUid = "2.25.1900";
    other.seriesUid = "2.25.1901";
    other.size.z = 2;
    const dicom::test::TemporaryFolder elsewhere;
    dicom::test::writeFiles(elsewhere.path(), other);

    trigger("send-to-archive");
    EXPECT_FALSE(in<QCheckBox>(dialog(), "send-picture").isEnabled()) << "no study is open";
    EXPECT_FALSE(in<QPushButton>(dialog(), "send-now").isEnabled());
    dialog().addFiles({elsewhere.path()});
    ASSERT_TRUE(waitUntil([&] { return in<QPushButton>(dialog(), "send-now").isEnabled(); }));
    EXPECT_TRUE(said(dialog(), "send-patients").contains(QStringLiteral("SYN2")));
    EXPECT_TRUE(said(dialog(), "send-warning").isEmpty());
    dialog().addFiles({folder_.path()});
    ASSERT_TRUE(waitUntil([&] { return !said(dialog(), "send-warning").isEmpty(); })) << "of two patients";
    press(dialog(), "send-no-files");
    EXPECT_FALSE(in<QPushButton>(dialog(), "send-now").isEnabled());
    dialog().addFiles({elsewhere.path() / "nothing"});
    ASSERT_TRUE(
        waitUntil([&] { return said(dialog(), "send-files-told") != QStringLiteral("Reading files…"); }));
    EXPECT_FALSE(in<QPushButton>(dialog(), "send-now").isEnabled());
    dialog().addFiles({elsewhere.path()});
    ASSERT_TRUE(waitUntil([&] { return in<QPushButton>(dialog(), "send-now").isEnabled(); }));
    press(dialog(), "send-now");
    ASSERT_TRUE(comes(QStringLiteral("2 objects are stored in Hospital.")))
        << window_->message().toStdString();
}

TEST_F(SendWindowTest, WhatCouldNotBeSentIsOfferedAfterARestartAndSentWhenAskedFor) {
    openStudy();
    archive_.stop();
    sendPictureAndView();
    ASSERT_TRUE(comes(QStringLiteral("2 objects wait in the queue."))) << window_->message().toStdString();
    EXPECT_TRUE(waitUntil([&] { return bar().text() == QStringLiteral("2 objects wait for Hospital."); }))
        << bar().text().toStdString();
    EXPECT_EQ(waitingEntries(), 1u);

    window_.reset();
    archive_.start();
    makeWindow();
    ASSERT_TRUE(waitUntil([&] { return bar().text() == QStringLiteral("2 objects wait for Hospital."); }));
    EXPECT_EQ(waitingEntries(), 1u) << "sent behind a person's back";
    press(bar(), "waiting-send");
    ASSERT_TRUE(comes(QStringLiteral("2 objects are stored."))) << window_->message().toStdString();
    EXPECT_EQ(waitingEntries(), 0u);
    EXPECT_EQ(storedObjects(), 2u);
    EXPECT_TRUE(bar().text().isEmpty());
}

TEST_F(SendWindowTest, AnArchiveThatAnswersAgainIsTold) {
    openStudy();
    archive_.stop();
    sendPictureAndView();
    ASSERT_TRUE(waitUntil([&] { return !bar().text().isEmpty(); })) << window_->message().toStdString();
    press(bar(), "waiting-later");
    EXPECT_TRUE(bar().text().isEmpty());
    archive_.start();
    window_->findChild<SendController*>()->setAsksEvery(std::chrono::milliseconds(50));
    ASSERT_TRUE(waitUntil([&] { return bar().text() == QStringLiteral("2 objects wait for Hospital."); }));
    EXPECT_EQ(waitingEntries(), 1u);
    EXPECT_EQ(storedObjects(), 0u);
}

TEST_F(SendWindowTest, TheQueueIsShownAndEmptied) {
    openStudy();
    archive_.stop();
    sendPictureAndView();
    ASSERT_TRUE(waitUntil([&] { return !bar().text().isEmpty(); })) << window_->message().toStdString();
    press(bar(), "waiting-show");
    auto* queue = window_->findChild<QueueDialog*>();
    ASSERT_NE(queue, nullptr);
    auto& list = in<QTreeWidget>(*queue, "queue-entries");
    ASSERT_TRUE(waitUntil([&] { return list.topLevelItemCount() == 1; }));
    const auto rowHas = [&](const char* words) {
        QString row;
        for (int i = 0; i < list.columnCount(); ++i) row += list.topLevelItem(0)->text(i) + QLatin1Char('|');
        return row.contains(QLatin1String(words));
    };
    EXPECT_TRUE(rowHas("SYNTHETIC, ONE"));
    EXPECT_TRUE(rowHas("Hospital"));
    EXPECT_TRUE(rowHas("waits, after 1 tr"));
    EXPECT_TRUE(said(*queue, "queue-why").contains(QStringLiteral("port")))
        << said(*queue, "queue-why").toStdString();
    trigger("names");
    EXPECT_FALSE(rowHas("SYN"));
    trigger("names");
    press(*queue, "queue-remove");
    auto* asked = queue->findChild<QMessageBox*>(QStringLiteral("queue-remove-question"));
    ASSERT_NE(asked, nullptr);
    EXPECT_EQ(waitingEntries(), 1u) << "removed without an answer";
    for (QAbstractButton* button : asked->buttons())
        if (asked->buttonRole(button) == QMessageBox::DestructiveRole) button->click();
    EXPECT_TRUE(waitUntil([&] { return list.topLevelItemCount() == 0; }));
    EXPECT_EQ(waitingEntries(), 0u);
    EXPECT_TRUE(bar().text().isEmpty());
}

// Of a study that was fetched, the archive that it came from comes first.
TEST_F(SendWindowTest, TheArchiveOfTheStudyIsChosenAtFirst) {
    auto list = net::SourceList::read(net::SourceFiles::ofUser());
    net::Source other = source();
    other.name = "Another";
    ASSERT_TRUE(list && list->put(other));
    const fs::path study = study::spoolFolder() / "0123456789abcdef0123456789abcdef";
    dicom::test::writeFiles(study, series_);
    ASSERT_TRUE(study::writeSpoolRecord(
        study, {.studyInstanceUid = series_.studyUid, .source = "Another", .isComplete = true}));
    openStudy();
    trigger("send-to-archive");
    EXPECT_EQ(in<QComboBox>(dialog(), "send-archive").currentText(), QStringLiteral("Hospital"));
    dialog().reject();
    ASSERT_TRUE(waitUntil([&] { return window_->findChild<SendDialog*>() == nullptr; }));
    window_->open(study);
    ASSERT_TRUE(waitUntil([&] { return !window_->loading(); }));
    trigger("send-to-archive");
    EXPECT_EQ(in<QComboBox>(dialog(), "send-archive").currentText(), QStringLiteral("Another"));
    dialog().reject();
    fs::remove_all(study);
    ASSERT_TRUE(list->remove("Another"));
}

}  // namespace
}  // namespace macula::viewer
