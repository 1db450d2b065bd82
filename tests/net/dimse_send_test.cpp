// Sending files, to DCMTK's storescp, its archive and Orthanc.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <gtest/gtest.h>

#include <fstream>

#include "net/dimse/contexts.h"
#include "net/dimse_support.h"
#include "net/hostile_peer.h"
#include "net/servers.h"

namespace macula::net::test {

namespace {

using dicom::test::TemporaryFolder;
using Paths = std::vector<std::filesystem::path>;

Paths pathsOf(const std::map<std::string, std::filesystem::path>& files) {
    Paths paths;
    for (const auto& [uid, file] : files) paths.push_back(file);
    return paths;
}

Sent sentBy(Archive& archive, const Paths& files) {
    Progress progress;
    const Result<Sent> sent = archive.send(files, progress);
    EXPECT_TRUE(sent) << told(sent.error());
    return sent ? *sent : Sent{};
}

// In every transfer syntax that can be made here.
Paths filesOfManyEncodings(const TemporaryFolder& folder) {
    Paths files;
    int i = 0;
    for (const char* syntax :
         {UID_LittleEndianImplicitTransferSyntax, UID_LittleEndianExplicitTransferSyntax,
          UID_BigEndianExplicitTransferSyntax, UID_DeflatedExplicitVRLittleEndianTransferSyntax}) {
        const SmallStudy study{.studyUid = "2.25.8100" + std::to_string(i),
                               .seriesCount = 1,
                               .slices = 1,
                               .transferSyntaxUid = syntax};
        for (const auto& file : pathsOf(writeStudy(folder / std::to_string(i++), study)))
            files.push_back(file);
    }
    const Paths plain = pathsOf(writeStudy(folder / "plain", {.studyUid = "2.25.8200", .seriesCount = 1}));
    const std::vector<std::vector<std::string>> commands{
        {programNamed("dcmcjpeg"), "+e1"}, {programNamed("dcmcjpls")}, {programNamed("dcmcrle")}};
    for (std::size_t j = 0; j < commands.size(); ++j) {
        std::vector<std::string> command = commands[j];
        const auto file = folder / ("compressed" + std::to_string(j));
        command.push_back(plain[j].string());
        command.push_back(file.string());
        const TemporaryFolder own;
        const Ran changed = ran(command, own.path());
        EXPECT_EQ(changed.exitCode, 0) << changed.output;
        files.push_back(file);
    }
    return files;
}

TEST(DimseSend, BytesAreNotChanged) {
    SKIP_WITHOUT_PROGRAM("storescp");
    SKIP_WITHOUT_PROGRAM("dcmcjpls");
    const TemporaryFolder folder;
    const Paths files = filesOfManyEncodings(folder);
    const StoreServer server;
    const Sent sent = sentBy(*archiveAt(peerAt(server.port(), server.title())), files);
    EXPECT_EQ(sent.stored, files.size());
    EXPECT_TRUE(sent.notSent.empty());
    std::multiset<std::string> expected;
    std::multiset<std::string> received;
    for (const auto& file : files) {
        std::string bytes = datasetBytes(file);
        if (bytes.size() % 2 != 0) bytes += '\0';  // a deflated one
        expected.insert(bytes);
    }
    for (const auto& file : server.files()) received.insert(datasetBytes(file));
    EXPECT_TRUE(expected == received) << server.output();
}

TEST(DimseSend, RoundTripOverOrthanc) {
    SKIP_WITHOUT_PROGRAM("Orthanc");
    const TemporaryFolder folder;
    const SmallStudy study;
    const auto files = writeStudy(folder.path(), study);
    const Orthanc server;
    const auto archive = archiveAt(peerAt(server.dicomPort(), server.title()));
    EXPECT_EQ(sentBy(*archive, pathsOf(files)).stored, files.size());
    FolderReceiver receiver;
    Progress progress;
    const auto fetched = archive->fetch({.studyInstanceUid = study.studyUid}, receiver, progress);
    ASSERT_TRUE(fetched) << told(fetched.error());
    expectSameDatasets(receiver.files(), files);
}

TEST(DimseSend, MoreKindsThanOneAssociationCarries) {
    SKIP_WITHOUT_PROGRAM("storescp");
    const TemporaryFolder folder;
    const Paths plain =
        pathsOf(writeStudy(folder / "plain", {.studyUid = "2.25.8300", .seriesCount = 1, .slices = 1}));
    std::ifstream stream(plain.front(), std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(stream), {}};
    Paths files;
    // Private classes, which storescp takes: only the file meta information is read here.
    for (int i = 0; i < 150; ++i) {
        const std::string kind = "1.2.840.10008.5.1.4.1.1.2";
        const std::string other = "1.2.840.10008.5.1.4.1.9." + std::to_string(100 + i);
        std::string bytes = whole;
        const std::size_t at = bytes.find(kind);
        ASSERT_NE(at, std::string::npos);
        // Of 27 characters and one of padding instead of 25 and one.
        bytes.replace(at - 2, 2 + 26,
                      std::string("\x1c\0", 2) + other + std::string(28 - other.size(), '\0'));
        bytes[140] = static_cast<char>(bytes[140] + 2);
        files.push_back(folder / ("kind" + std::to_string(i)));
        std::ofstream(files.back(), std::ios::binary) << bytes;
    }
    const StoreServer server({"--promiscuous"});
    const Sent sent = sentBy(*archiveAt(peerAt(server.port(), server.title())), files);
    EXPECT_EQ(sent.stored, files.size());
    EXPECT_TRUE(sent.notSent.empty()) << sent.notSent.front().why;
}

TEST(DimseSend, SaysWhyAFileDidNotGo) {
    SKIP_WITHOUT_PROGRAM("Orthanc");
    SKIP_WITHOUT_PROGRAM("dcmcjpls");
    const TemporaryFolder folder;
    const Paths files = filesOfManyEncodings(folder);
    const auto text = folder / "text.dcm";
    std::ofstream(text) << std::string(500, 'x');
    // Only implicit and explicit little endian.
    const Orthanc server(
        {.more = {{"AcceptedTransferSyntaxes", {"1.2.840.10008.1.2", "1.2.840.10008.1.2.1"}}}});
    Paths all = files;
    all.push_back(text);
    all.push_back(folder / "missing.dcm");
    const Sent sent = sentBy(*archiveAt(peerAt(server.dicomPort(), server.title())), all);
    EXPECT_EQ(sent.stored, 2u);
    ASSERT_EQ(sent.notSent.size(), all.size() - 2);
    std::size_t encodings = 0;
    for (const NotSent& each : sent.notSent) {
        EXPECT_FALSE(each.why.empty());
        EXPECT_FALSE(each.advice.empty());
        if (each.why.english() == "The archive does not take the encoding of this file.") ++encodings;
    }
    EXPECT_EQ(encodings, files.size() - 2);
}

// Answers each file with the next of some statuses.
struct StatusPeer {
    explicit StatusPeer(std::vector<std::uint16_t> statuses)
        : peer([statuses = std::move(statuses)](HostileLine& line) {
              if (!line.acceptAssociation()) return;
              for (const std::uint16_t status : statuses) {
                  const auto request = line.receiveCommandOf(CommandField::storeRequest);
                  if (!request) return;
                  line.sendCommand(request->context, {.field = CommandField::storeResponse,
                                                      .respondsTo = request->command.messageId,
                                                      .status = status});
              }
              while (line.receiveCommand()) continue;
          }) {}
    HostilePeer peer;
};

TEST(DimseSend, StatusesOfTheArchive) {
    const TemporaryFolder folder;
    const Paths files = pathsOf(writeStudy(folder.path(), {}));
    const StatusPeer peer({0x0000, 0xa700, 0xb000, 0xa900, 0xc123, 0x0122});
    const Sent sent = sentBy(*archiveAt(peerAt(peer.peer.port(), "HOSTILE")), files);
    EXPECT_EQ(sent.stored, 2u);  // a warning is stored
    ASSERT_EQ(sent.notSent.size(), 4u);
    EXPECT_EQ(sent.notSent[0].file, files[1]);
    EXPECT_EQ(sent.notSent[0].why,
              "The archive has no room for this instance, or cannot use it (status A700).");
    EXPECT_EQ(sent.notSent[3].file, files[5]);
}

TEST(DimseSend, GoesOnAfterABreak) {
    const TemporaryFolder folder;
    const Paths files = pathsOf(writeStudy(folder.path(), {}));
    // Takes two files, then closes.
    const HostilePeer peer([](HostileLine& line) {
        if (!line.acceptAssociation()) return;
        for (int i = 0; i < 2; ++i) {
            const auto request = line.receiveCommandOf(CommandField::storeRequest);
            if (!request) return;
            line.sendCommand(request->context, {.field = CommandField::storeResponse,
                                                .respondsTo = request->command.messageId,
                                                .status = std::uint16_t{0}});
        }
        line.receiveCommand();
    });
    const Sent sent = sentBy(*archiveAt(peerAt(peer.port(), "HOSTILE")), files);
    EXPECT_EQ(sent.stored, 6u);
    EXPECT_TRUE(sent.notSent.empty());
    EXPECT_GE(peer.connections(), 3);
}

TEST(DimseSend, AFileThatVanishesHoldsNobodyUp) {
    const TemporaryFolder folder;
    const Paths files = pathsOf(writeStudy(folder.path(), {}));
    // The first file is taken, and then the third goes.
    const HostilePeer peer([&](HostileLine& line) {
        if (!line.acceptAssociation()) return;
        while (const auto request = line.receiveCommandOf(CommandField::storeRequest)) {
            std::error_code ignored;
            std::filesystem::remove(files[2], ignored);
            line.sendCommand(request->context, {.field = CommandField::storeResponse,
                                                .respondsTo = request->command.messageId,
                                                .status = std::uint16_t{0}});
        }
    });
    const Sent sent = sentBy(*archiveAt(peerAt(peer.port(), "HOSTILE")), files);
    EXPECT_EQ(sent.stored, 5u);
    ASSERT_EQ(sent.notSent.size(), 1u);
    EXPECT_EQ(sent.notSent[0].file, files[2]);
}

TEST(DimseSend, ACancelSaysWhatWasStored) {
    const TemporaryFolder folder;
    const Paths files = pathsOf(writeStudy(folder.path(), {}));
    const CancelToken token;
    const HostilePeer peer([&](HostileLine& line) {
        if (!line.acceptAssociation()) return;
        for (int i = 0; i < 2; ++i) {
            const auto request = line.receiveCommandOf(CommandField::storeRequest);
            if (!request) return;
            line.sendCommand(request->context, {.field = CommandField::storeResponse,
                                                .respondsTo = request->command.messageId,
                                                .status = std::uint16_t{0}});
        }
        line.receiveCommandOf(CommandField::storeRequest);
        token.cancel();
        while (line.receivePdu()) continue;
    });
    Progress progress({}, token);
    const auto sent = archiveAt(peerAt(peer.port(), "HOSTILE"))->send(files, progress);
    ASSERT_FALSE(sent);
    EXPECT_EQ(sent.error().code, ErrorCode::cancelled);
    EXPECT_EQ(sent.error().message.english(), "2 of 6 files were stored before this was cancelled.");
}

}  // namespace

}  // namespace macula::net::test
