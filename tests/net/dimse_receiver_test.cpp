// The receiver for C-MOVE, against somebody who misuses it; and what DCMTK logs meanwhile.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/oflog/appender.h>
#include <dcmtk/oflog/oflog.h>
#include <dcmtk/oflog/spi/logevent.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <functional>
#include <memory>
#include <optional>
#include <thread>

#include "net/dimse_support.h"
#include "net/hostile_peer.h"
#include "net/servers.h"

namespace macula::net::test {

namespace {

const std::string kCtImages = "1.2.840.10008.5.1.4.1.1.2";
const std::string kExplicitSyntax = "1.2.840.10008.1.2.1";

// A connection to the receiver.
class Caller {
  public:
    explicit Caller(std::uint16_t port) : socket_(connectionTo(port)), line_(socket_) {}
    ~Caller() { close(socket_); }
    Caller(const Caller&) = delete;
    Caller& operator=(const Caller&) = delete;
    HostileLine* operator->() { return &line_; }

    // The status of the response; nothing without one.
    std::optional<std::uint16_t> store(const std::string& study, const std::string& sopInstanceUid) {
        line_.sendCommand(1, {.field = CommandField::storeRequest,
                              .messageId = std::uint16_t{1},
                              .sopClassUid = kCtImages,
                              .sopInstanceUid = sopInstanceUid,
                              .hasDataset = true});
        line_.sendFragment(1, false, true,
                           joined({explicitElement(0x00080018, "UI", sopInstanceUid),
                                   explicitElement(0x0020000d, "UI", study)}));
        const auto response = line_.receiveCommand();
        return response ? response->command.status : std::nullopt;
    }

  private:
    int socket_;
    HostileLine line_;
};

// An archive that answers C-MOVE after it did what the test wants.
Result<Fetched> movedBy(const std::function<void(std::uint16_t port)>& misuse, Receiver& receiver) {
    const std::uint16_t port = freePort();
    const HostilePeer peer([&](HostileLine& line) {
        if (!line.acceptAssociation()) return;
        while (const auto request = line.receiveCommand()) {
            const bool isMove = request->command.field == CommandField::moveRequest;
            if (isMove) misuse(port);
            line.sendCommand(request->context,
                             {.field = isMove ? CommandField::moveResponse : CommandField::findResponse,
                              .respondsTo = request->command.messageId,
                              .status = isMove ? std::uint16_t{0} : std::uint16_t{0xc000}});
        }
    });
    DimsePeer settings = peerAt(peer.port(), "HOSTILE");
    settings.retrieve = Retrieve::move;
    settings.receiverAe = "RECEIVER";
    settings.receiverPort = port;
    settings.receiverAddress = "127.0.0.1";
    Progress progress;
    auto result = archiveAt(settings, {}, std::chrono::seconds(5))
                      ->fetch({.studyInstanceUid = "2.25.1"}, receiver, progress);
    EXPECT_FALSE(answersAt(port)) << "it still listens";
    return result;
}

TEST(DimseReceiver, TakesWhatWasAskedForAlone) {
    FolderReceiver receiver;
    const auto result = movedBy(
        [](std::uint16_t port) {
            EXPECT_FALSE(Caller(port)->requestAssociation("SOMEBODY", kCtImages, kExplicitSyntax));
            EXPECT_FALSE(
                Caller(port)->requestAssociation("RECEIVER", "1.2.840.10008.5.1.4.1.2.2.1", kExplicitSyntax));
            EXPECT_FALSE(Caller(port)->requestAssociation("RECEIVER", kCtImages, "1.2.3.4"));
            Caller caller(port);
            ASSERT_TRUE(caller->requestAssociation("RECEIVER", kCtImages, kExplicitSyntax));
            EXPECT_EQ(caller.store("2.25.1", "2.25.1.1"), 0x0000);
            EXPECT_EQ(caller.store("2.25.2", "2.25.2.1"), 0xa900);
            EXPECT_EQ(caller.store("2.25.1", "../2.25.1.2"), 0xa900);
            EXPECT_EQ(caller.store("2.25.1", "2.25.1.1"), 0x0000);  // again
        },
        receiver);
    ASSERT_TRUE(result) << told(result.error());
    EXPECT_EQ(result->kept, 1u);
    EXPECT_EQ(result->hadAlready, 1u);
    EXPECT_EQ(result->refused, 2u);
}

TEST(DimseReceiver, OutlivesWhatIsNoDicom) {
    FolderReceiver receiver;
    const auto result = movedBy(
        [](std::uint16_t port) {
            Caller(port)->sendAll(Bytes(100, 0xff));
            Caller(port)->sendAll({1, 0, 0xff, 0xff, 0xff, 0xff});
            Caller(port)->sendPdu(1, Bytes(3, 0));
            Caller(port)->sendPdu(4, Bytes(8, 0));
            {
                Caller midway(port);
                ASSERT_TRUE(midway->requestAssociation("RECEIVER", kCtImages, kExplicitSyntax));
                midway->sendCommand(1, {.field = CommandField::storeRequest,
                                        .messageId = std::uint16_t{1},
                                        .sopClassUid = kCtImages,
                                        .sopInstanceUid = "2.25.1.9",
                                        .hasDataset = true});
                midway->sendFragment(1, false, false, Bytes(100, 'x'));
            }
            {
                Caller other(port);
                ASSERT_TRUE(other->requestAssociation("RECEIVER", kCtImages, kExplicitSyntax));
                other->sendCommand(1, {.field = CommandField::findRequest, .messageId = std::uint16_t{1}});
                EXPECT_FALSE(other->receiveCommand());
            }
            std::vector<std::unique_ptr<Caller>> idle;
            for (int i = 0; i < 12; ++i) idle.push_back(std::make_unique<Caller>(port));
            idle.clear();
            // They make room when they have gone.
            EXPECT_TRUE(comes([&] {
                Caller caller(port);
                return caller->requestAssociation("RECEIVER", kCtImages, kExplicitSyntax) &&
                       caller.store("2.25.1", "2.25.1.1") == 0x0000;
            }));
        },
        receiver);
    ASSERT_TRUE(result) << told(result.error());
    EXPECT_EQ(result->kept, 1u);
    EXPECT_EQ(receiver.filesInFolder(), 1u) << "a part of an instance was left";
}

// All that DCMTK logs at any level, in any thread.
class LogOfToolkit : public dcmtk::log4cplus::Appender {
  public:
    explicit LogOfToolkit(std::string& text) : text_(text) {}
    ~LogOfToolkit() override { destructorImpl(); }
    void close() override {}

  protected:
    void append(const dcmtk::log4cplus::spi::InternalLoggingEvent& event) override {
        text_ += std::string(event.getMessage().c_str()) + "\n";
    }

  private:
    std::string& text_;
};

TEST(DimseLogs, NobodyIsNamed) {
    SKIP_WITHOUT_PROGRAM("dcmqrscp");
    SKIP_WITHOUT_PROGRAM("dcmsend");
    const dicom::test::TemporaryFolder folder;
    const SmallStudy study;
    const auto files = writeStudy(folder.path(), study);
    const std::uint16_t receiverPort = freePort();
    const QrArchive server({.known = {{"RECEIVER", receiverPort}}});
    DimsePeer peer = peerAt(server.port(), server.title());
    peer.receiverAe = "RECEIVER";
    peer.receiverPort = receiverPort;
    peer.receiverAddress = "127.0.0.1";

    OFLog::configure(OFLogger::TRACE_LOG_LEVEL);
    std::string logged;
    dcmtk::log4cplus::Logger root = dcmtk::log4cplus::Logger::getRoot();
    root.removeAllAppenders();
    const dcmtk::log4cplus::SharedAppenderPtr appender(new LogOfToolkit(logged));
    root.addAppender(appender);
    Progress progress;
    std::vector<std::filesystem::path> paths;
    for (const auto& [uid, file] : files) paths.push_back(file);
    EXPECT_TRUE(archiveAt(peer)->send(paths, progress));
    EXPECT_TRUE(archiveAt(peer)->findStudies({.patientName = "MEIER*"}, progress));
    for (const Retrieve way : {Retrieve::get, Retrieve::move}) {
        peer.retrieve = way;
        FolderReceiver receiver;
        EXPECT_TRUE(archiveAt(peer)->fetch({.studyInstanceUid = study.studyUid}, receiver, progress));
        EXPECT_EQ(receiver.files().size(), files.size());
    }
    EXPECT_FALSE(archiveAt(peerAt(server.port(), "OTHER"))->findStudies({.patientName = "MEIER*"}, progress));
    root.removeAppender(appender);
    OFLog::configure(OFLogger::OFF_LOG_LEVEL);
    EXPECT_EQ(logged, "");
}

TEST(DimseReceiver, BytesOfAStrangerAreNoSignOfLife) {
    FolderReceiver receiver;
    const auto result = movedBy(
        [](std::uint16_t port) {
            // Longer than the answer may take; a byte now and then of a request that is not complete.
            Caller stranger(port);
            stranger->sendAll({1, 0, 0, 0, 0x10, 0});
            for (int i = 0; i < 70; ++i) {
                if (!stranger->sendAll({0})) return;
                std::this_thread::sleep_for(std::chrono::milliseconds(100));
            }
        },
        receiver);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().message.english(),
              "The archive took the connection and then did not answer in time.");
}

}  // namespace

}  // namespace macula::net::test
