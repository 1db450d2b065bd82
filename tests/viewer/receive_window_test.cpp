// Studies that others send to the window: real senders, which it takes only when it was asked to.
#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QTreeView>
#include <atomic>
#include <fstream>
#include <mutex>
#include <thread>

#include "net/certificates.h"
#include "net/servers.h"
#include "net/sources/source_list.h"
#include "study/archive/receiving.h"
#include "study/spool/spool.h"
#include "synthetic.h"
#include "viewer/receive/receive_controller.h"
#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

namespace fs = std::filesystem;

class ReceiveWindowTest : public WindowTest {
  protected:
    ReceiveWindowTest() {
        series_.size = {16, 14, 12};
        dicom::test::writeFiles(folder_ / "study", series_);
        fs::remove_all(userDataFolder() / "fetched");
        settings_.receiving.port = net::test::freePort();
        watchPace_.quiet = std::chrono::milliseconds(500);
    }
    void SetUp() override {
        WindowTest::SetUp();
        if (IsSkipped()) return;
        auto list = net::SourceList::read(net::SourceFiles::ofUser());
        ASSERT_TRUE(list);
        for (const net::Source& each : std::vector(list->all())) ASSERT_TRUE(list->remove(each.name));
    }
    template <class Widget>
    Widget& named(const char* name) {
        auto* found = window_->findChild<Widget*>(QString::fromLatin1(name));
        EXPECT_NE(found, nullptr) << name;
        return *found;
    }
    std::uint16_t port() const { return std::uint16_t(settings_.receiving.port); }
    QAction& action() { return named<QAction>("receive"); }
    ReceiveController& controller() { return *window_->findChild<ReceiveController*>(); }
    QString state() { return named<QLabel>("receive-state").isVisible() ? controller().text() : QString(); }
    QString arrived() {
        auto& label = named<QLabel>("arrival-text");
        return label.isVisible() ? label.text() : QString();
    }
    void switchOn() {
        action().trigger();
        ASSERT_TRUE(waitUntil([&] { return !state().isEmpty(); })) << window_->message().toStdString();
    }
    void send() { net::test::sendFolder(folder_ / "study", port(), "MACULA"); }
    void searchHere() {
        for (QAction* action : window_->findChildren<QAction*>()) {
            if (action->shortcut() == QKeySequence(QStringLiteral("Ctrl+Shift+A"))) action->trigger();
        }
        QTest::keyClicks(&named<QLineEdit>("archive-patient"), QStringLiteral("synth"));
        QTest::keyClick(&named<QLineEdit>("archive-patient"), Qt::Key_Return);
        ASSERT_TRUE(waitUntil([&] { return remark() == QStringLiteral("No study matches."); }))
            << remark().toStdString();
    }
    int rows() { return named<QTreeView>("archive-studies").model()->rowCount(); }
    QString remark() { return named<QLabel>("archive-remark").text(); }

    dicom::test::SyntheticSeries series_;
    dicom::test::TemporaryFolder folder_;
};

TEST_F(ReceiveWindowTest, NothingListensUnlessAsked) {
    EXPECT_FALSE(action().isChecked());
    for (int turns = 0; turns < 20; ++turns) QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
    EXPECT_TRUE(state().isEmpty());
    EXPECT_TRUE(controller().atRest());
    EXPECT_FALSE(net::test::answersAt(port()));
}

TEST_F(ReceiveWindowTest, WhatIsSentIsAnnouncedAndListedAndOpensOnlyWhenAsked) {
    searchHere();
    switchOn();
    EXPECT_EQ(state(), QStringLiteral("Receives as MACULA at port %1").arg(port()));
    EXPECT_TRUE(action().isChecked());
    send();
    ASSERT_TRUE(waitUntil([&] { return arrived().contains(QStringLiteral("12 images")); }))
        << arrived().toStdString() << window_->message().toStdString();
    EXPECT_TRUE(arrived().contains(QStringLiteral("was sent by SENDER: CT, 12 images")))
        << arrived().toStdString();
    EXPECT_TRUE(arrived().contains(QStringLiteral("Synth"), Qt::CaseInsensitive)) << arrived().toStdString();
    ASSERT_TRUE(waitUntil([&] { return rows() == 1; })) << remark().toStdString();
    EXPECT_FALSE(window_->hasStudy());
    EXPECT_FALSE(window_->loading());

    window_->findChild<QAction*>(QStringLiteral("names"))->trigger();
    EXPECT_FALSE(arrived().contains(QStringLiteral("Synth"), Qt::CaseInsensitive)) << arrived().toStdString();
    window_->findChild<QAction*>(QStringLiteral("names"))->trigger();
    QTest::mouseClick(&named<QPushButton>("arrival-open"), Qt::LeftButton);
    ASSERT_TRUE(waitUntil([&] { return window_->voxels().contains(QStringLiteral("16×14×12")); }))
        << window_->message().toStdString();
    EXPECT_TRUE(window_->notes().contains(QStringLiteral("without saying how many images")))
        << window_->notes().toStdString();
    EXPECT_TRUE(arrived().isEmpty());

    action().trigger();
    ASSERT_TRUE(waitUntil([&] { return controller().atRest(); }));
    EXPECT_TRUE(state().isEmpty());
    EXPECT_FALSE(net::test::answersAt(port()));
}

class SlowReceiveWindowTest : public ReceiveWindowTest {
  protected:
    SlowReceiveWindowTest() { watchPace_.quiet = std::chrono::hours(1); }
};

TEST_F(SlowReceiveWindowTest, IsListedWhileItArrivesAndAnnouncedWhenItWasSwitchedOff) {
    searchHere();
    switchOn();
    send();
    ASSERT_TRUE(waitUntil([&] { return rows() == 1; })) << remark().toStdString();
    EXPECT_TRUE(state().contains(QStringLiteral("12 images are arriving"))) << state().toStdString();
    EXPECT_TRUE(arrived().isEmpty()) << arrived().toStdString();
    action().trigger();
    ASSERT_TRUE(waitUntil([&] { return arrived().contains(QStringLiteral("12 images")); }));
    EXPECT_FALSE(window_->hasStudy());
}

// Without an end of its own: the association lasts until somebody cuts it.
TEST_F(SlowReceiveWindowTest, ClosingTheWindowEndsAnAssociation) {
    const std::string storescu = net::test::programNamed("storescu");
    if (storescu.empty()) GTEST_SKIP() << "storescu is not installed on this machine";
    switchOn();
    const fs::path file = fs::directory_iterator(folder_ / "study")->path();
    net::test::Program sender({storescu, "--repeat", "100000000", "-aec", "MACULA", "127.0.0.1",
                               std::to_string(port()), file.string()},
                              folder_.path());
    ASSERT_TRUE(waitUntil([&] { return state().contains(QStringLiteral("arriving")); }))
        << sender.output() << state().toStdString();
    ASSERT_TRUE(sender.isRunning()) << sender.output();
    window_.reset();
    EXPECT_FALSE(net::test::answersAt(port()));
    EXPECT_NE(sender.exitCode(), 0) << sender.output();
    const auto spool = study::Spool::open();
    ASSERT_TRUE(spool);
    ASSERT_EQ(spool->entries().size(), 1u) << "what came is kept";
    EXPECT_EQ(spool->entries().front().instances, 1u);
}

TEST_F(ReceiveWindowTest, OtherSettingsAreUsedAtOnce) {
    switchOn();
    Settings settings = window_->settings();
    settings.receiving.port = net::test::freePort();
    settings.receiving.title = QStringLiteral("INBOX");
    window_->takeSettings(settings);
    ASSERT_TRUE(waitUntil([&] { return state().contains(QStringLiteral("INBOX")); }))
        << state().toStdString() << window_->message().toStdString();
    EXPECT_TRUE(net::test::answersAt(std::uint16_t(settings.receiving.port)));
    EXPECT_FALSE(net::test::answersAt(port()));
    EXPECT_TRUE(action().isChecked());
}

TEST_F(ReceiveWindowTest, WhoMayNotSendIsTurnedAwayAndToldOf) {
    Settings settings = window_->settings();
    settings.receiving.callers = {QStringLiteral("CT1@127.0.0.1")};
    window_->takeSettings(settings);
    switchOn();
    const net::test::Ran sent =
        net::test::ran({net::test::programNamed("dcmsend"), "--call", "MACULA", "+sd", "127.0.0.1",
                        std::to_string(port()), (folder_ / "study").string()},
                       folder_.path());
    EXPECT_NE(sent.exitCode, 0) << sent.output;
    const auto& label = named<QLabel>("receive-state");
    ASSERT_TRUE(waitUntil([&] {
        return label.toolTip().contains(QStringLiteral("not among those that may"));
    })) << label.toolTip().toStdString();
    EXPECT_EQ(study::Spool::open()->entries().size(), 0u);
}

TEST_F(ReceiveWindowTest, ACertificateEncryptsIt) {
    const std::string storescu = net::test::programNamed("storescu");
    if (storescu.empty()) GTEST_SKIP() << "storescu is not installed on this machine";
    const dicom::test::TemporaryFolder keys;
    const net::test::Authority authority(keys.path());
    const net::test::Certificate own = authority.sign("window");
    Settings settings = window_->settings();
    settings.receiving.certificate = QString::fromStdString(own.certificate.string());
    settings.receiving.key = QString::fromStdString(own.key.string());
    window_->takeSettings(settings);
    switchOn();
    const auto sent = [&](const std::vector<std::string>& options) {
        std::vector<std::string> command{storescu, "-aec", "MACULA"};
        command.insert(command.end(), options.begin(), options.end());
        command.insert(command.end(), {"127.0.0.1", std::to_string(port()),
                                       fs::directory_iterator(folder_ / "study")->path().string()});
        return net::test::ran(command, folder_.path());
    };
    EXPECT_NE(sent({}).exitCode, 0) << "in the clear";
    const net::test::Ran encrypted = sent({"+tla", "+cf", authority.file().string()});
    EXPECT_EQ(encrypted.exitCode, 0) << encrypted.output;
    EXPECT_TRUE(waitUntil([&] { return arrived().contains(QStringLiteral("1 image")); }))
        << arrived().toStdString();
}

TEST_F(ReceiveWindowTest, WhyItCannotReceiveIsSaid) {
    const auto fails = [&](const ReceiveSettings& receiving) {
        Settings settings = window_->settings();
        settings.receiving = receiving;
        window_->takeSettings(settings);
        action().trigger();
        EXPECT_TRUE(waitUntil([&] { return !action().isChecked() && controller().atRest(); }));
        EXPECT_TRUE(state().isEmpty());
        return window_->message().toStdString();
    };
    ReceiveSettings receiving;
    receiving.port = port();
    receiving.address.clear();
    EXPECT_NE(fails(receiving).find("nobody said which may"), std::string::npos)
        << window_->message().toStdString();
    receiving.callers = {QStringLiteral("CT1@pacs")};
    EXPECT_NE(fails(receiving).find("pacs is no address"), std::string::npos)
        << window_->message().toStdString();
    receiving = {};
    receiving.port = port();
    receiving.certificate = QStringLiteral("/nowhere.pem");
    EXPECT_NE(fails(receiving).find("cannot be read"), std::string::npos) << window_->message().toStdString();
    receiving.certificate.clear();
    receiving.address = QStringLiteral("192.0.2.1");
    receiving.admitsAnyone = true;
    EXPECT_NE(fails(receiving).find("no such address"), std::string::npos)
        << window_->message().toStdString();
    {
        const net::test::StoreServer other;
        receiving = {};
        receiving.port = other.port();
        EXPECT_NE(fails(receiving).find("Another program already listens"), std::string::npos)
            << window_->message().toStdString();
    }
    fs::remove_all(userDataFolder() / "fetched");
    std::ofstream(userDataFolder() / "fetched") << "no folder";
    receiving = {};
    receiving.port = port();
    EXPECT_NE(fails(receiving).find("cannot be made"), std::string::npos) << window_->message().toStdString();
    fs::remove(userDataFolder() / "fetched");
}

TEST_F(ReceiveWindowTest, AnotherWindowThatHasThePortIsSaid) {
    study::ReceivingOptions options;
    options.provider.port = port();
    const auto first = study::Receiving::start(options);
    ASSERT_TRUE(first) << first.error().message;
    action().trigger();
    ASSERT_TRUE(waitUntil([&] {
        return window_->message().contains(QStringLiteral("Another window of Macula"));
    })) << window_->message().toStdString();
    EXPECT_FALSE(action().isChecked());
}

class ReceiveAtStartTest : public ReceiveWindowTest {
  protected:
    ReceiveAtStartTest() { settings_.receiving.atStart = true; }
};

TEST_F(ReceiveAtStartTest, ReceivesFromTheStartWhereThatIsSet) {
    ASSERT_TRUE(waitUntil([&] { return !state().isEmpty(); })) << window_->message().toStdString();
    EXPECT_TRUE(action().isChecked());
    EXPECT_TRUE(net::test::answersAt(port()));
}

// Without a window: what one would tell.
TEST(Reception, ForWhichThereIsNoRoomIsTold) {
    const dicom::test::TemporaryFolder folder;
    dicom::test::SyntheticSeries series;
    series.size = {16, 14, 2};
    dicom::test::writeFiles(folder / "study", series);
    study::ReceivingOptions options;
    options.provider.port = 0;
    options.provider.mostBytes = 100;
    options.into = folder / "spool";
    const CancelToken stop;
    std::atomic<std::uint16_t> port{0};
    std::mutex mutex;
    std::string trouble;
    std::thread thread([&] {
        const Progress progress;
        const auto end = receiveUntilStopped(options, stop, progress, [&](const ReceptionNews& news) {
            port = news.port;
            const std::lock_guard lock(mutex);
            if (news.trouble) trouble = news.trouble->message.english();
        });
        EXPECT_TRUE(end);
    });
    EXPECT_TRUE(net::test::comes([&] { return port != 0; }));
    net::test::ran({net::test::programNamed("dcmsend"), "--call", "MACULA", "+sd", "127.0.0.1",
                    std::to_string(port), (folder / "study").string()},
                   folder.path());
    EXPECT_TRUE(net::test::comes([&] {
        const std::lock_guard lock(mutex);
        return trouble.find("Not all that was sent was kept") != std::string::npos;
    }));
    stop.cancel();
    thread.join();
}

}  // namespace
}  // namespace macula::viewer
