// Links that a program hands to the window that is there.
#include "viewer/links/link_socket.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <QLocalSocket>
#include <QTemporaryDir>
#include <atomic>
#include <chrono>
#include <thread>

#include "study/link/link_text.h"
#include "viewer/offscreen.h"

namespace macula::viewer {
namespace {

namespace fs = std::filesystem;

class LinkSocketTest : public test::OffscreenTest {
  protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        before_ = qgetenv("XDG_RUNTIME_DIR");
        qputenv("XDG_RUNTIME_DIR", runtime_.path().toUtf8());
    }
    void TearDown() override {
        qputenv("XDG_RUNTIME_DIR", before_);
        OffscreenTest::TearDown();
    }
    // From another thread, as from another program.
    bool handedOver(const QString& link) {
        std::atomic<int> taken{-1};
        std::thread other([&] { taken = handOver(link) ? 1 : 0; });
        waitUntil([&] { return taken >= 0; });
        other.join();
        return taken == 1;
    }
    fs::path socketOf() const {
        const fs::path folder = *linkSocketFolder();
        for (const auto& entry : fs::directory_iterator(folder)) return entry.path();
        return {};
    }
    // What the server answers to these bytes.
    QByteArray answerTo(const QByteArray& bytes) {
        QLocalSocket socket;
        socket.connectToServer(QString::fromStdString(socketOf().string()));
        socket.write(bytes);
        QByteArray answer;
        waitUntil([&] {
            answer += socket.readAll();
            return socket.state() == QLocalSocket::UnconnectedState || answer.endsWith('\n');
        });
        return answer;
    }

    QTemporaryDir runtime_;
    QByteArray before_;
};

TEST_F(LinkSocketTest, ALinkReachesTheWindowThatIsThere) {
    const QString link = QStringLiteral("macula://open?patient=M%C3%BCller");
    EXPECT_FALSE(handedOver(link)) << "nobody is there";
    QStringList came;
    {
        LinkServer server;
        ASSERT_TRUE(server.isListening());
        QObject::connect(&server, &LinkServer::linkCame, [&](const QString& text) { came.append(text); });
        struct stat status {};
        ASSERT_EQ(stat(socketOf().c_str(), &status), 0);
        EXPECT_EQ(status.st_mode & 077, 0u) << "others could reach the window";
        EXPECT_TRUE(handedOver(link));
        EXPECT_TRUE(handedOver(QStringLiteral("macula://close?"))) << "the window says what is wrong with it";
    }
    EXPECT_EQ(came, (QStringList{link, QStringLiteral("macula://close?")}));
    EXPECT_FALSE(handedOver(link)) << "the window was closed";
}

TEST_F(LinkSocketTest, WhatIsNoLinkIsDroppedUnanswered) {
    LinkServer server;
    int came = 0;
    QObject::connect(&server, &LinkServer::linkCame, [&] { ++came; });
    EXPECT_TRUE(answerTo("/etc/passwd\n").isEmpty());
    EXPECT_TRUE(answerTo("--preset ct-bone\n").isEmpty());
    EXPECT_TRUE(answerTo("\n").isEmpty());
    EXPECT_TRUE(answerTo("macula://open?study=" + QByteArray(int(study::kMostBytesOfLink), '1')).isEmpty());
    EXPECT_TRUE(answerTo(QByteArray(100'000, 'x')).isEmpty());
    EXPECT_EQ(came, 0);
    EXPECT_EQ(answerTo("macula://open?study=1.2\nmacula://open?study=1.3\n"), "ok\n");
    EXPECT_EQ(came, 1) << "one link for each message";
}

TEST_F(LinkSocketTest, ASocketThatAKilledWindowLeftIsPassedOver) {
    { LinkServer server; }
    const fs::path folder = *linkSocketFolder();
    LinkServer server;
    fs::path stale = socketOf();
    stale += "0";
    // Bound, and nobody listens any more.
    const QByteArray path = QByteArray::fromStdString(stale.string());
    {
        QLocalServer left;
        ASSERT_TRUE(left.listen(QString::fromUtf8(path)));
        fs::create_hard_link(path.toStdString(), folder / "kept");
    }
    fs::rename(folder / "kept", stale);
    fs::last_write_time(stale, fs::file_time_type::clock::now() + std::chrono::minutes(1));  // tried first
    EXPECT_TRUE(handedOver(QStringLiteral("macula://open?study=1.2")));
    EXPECT_FALSE(fs::exists(stale));
}

TEST_F(LinkSocketTest, AFolderThatOthersCanEnterIsNotUsed) {
    ASSERT_TRUE(linkSocketFolder());
    fs::permissions(*linkSocketFolder(), fs::perms(0755));
    EXPECT_FALSE(linkSocketFolder());
    EXPECT_FALSE(LinkServer().isListening());
    qunsetenv("XDG_RUNTIME_DIR");
    EXPECT_FALSE(linkSocketFolder());
    qputenv("XDG_RUNTIME_DIR", "relative");
    EXPECT_FALSE(linkSocketFolder());
}

}  // namespace
}  // namespace macula::viewer
