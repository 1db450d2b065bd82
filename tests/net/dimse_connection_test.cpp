// Tests of a source step by step, protected connections, and what the settings may be.
#include <gtest/gtest.h>

#include "net/dimse_support.h"
#include "net/hostile_peer.h"
#include "net/servers.h"

namespace macula::net::test {

namespace {

using dicom::test::TemporaryFolder;

std::vector<TestStep> tested(const DimsePeer& peer, const Secrets& secrets = {}) {
    Progress progress;
    return archiveAt(peer, secrets)->test(progress);
}

// All steps but the last passed, and the last says this.
void expectEnd(const std::vector<TestStep>& steps, const std::string& name, const std::string& detail) {
    ASSERT_FALSE(steps.empty());
    for (std::size_t i = 0; i + 1 < steps.size(); ++i) EXPECT_TRUE(steps[i].passed) << told(steps);
    EXPECT_FALSE(steps.back().passed) << told(steps);
    EXPECT_EQ(steps.back().name.english(), name) << told(steps);
    EXPECT_EQ(steps.back().detail.english(), detail) << told(steps);
    EXPECT_FALSE(steps.back().advice.empty()) << told(steps);
}

void expectAllPassed(const std::vector<TestStep>& steps, std::size_t count) {
    EXPECT_EQ(steps.size(), count) << told(steps);
    for (const TestStep& step : steps) {
        EXPECT_TRUE(step.passed) << told(steps);
        EXPECT_TRUE(step.advice.empty()) << told(steps);
        EXPECT_FALSE(step.detail.empty()) << told(steps);
    }
}

TEST(DimseConnection, GoodArchivesPass) {
    SKIP_WITHOUT_PROGRAM("dcmqrscp");
    SKIP_WITHOUT_PROGRAM("Orthanc");
    const QrArchive dcmtk;
    expectAllPassed(tested(peerAt(dcmtk.port(), dcmtk.title())), 6);
    const Orthanc orthanc;
    expectAllPassed(tested(peerAt(orthanc.dicomPort(), orthanc.title())), 6);
    DimsePeer byName = peerAt(orthanc.dicomPort(), orthanc.title());
    byName.host = "localhost";
    expectAllPassed(tested(byName), 6);
}

TEST(DimseConnection, StepsSayWhatIsWrong) {
    SKIP_WITHOUT_PROGRAM("dcmqrscp");
    DimsePeer nowhere = peerAt(freePort(), "ARCHIVE");
    expectEnd(tested(nowhere), "Port", "The archive's machine is there, but nothing answers at this port.");
    nowhere.host = "no-such-host.invalid";
    expectEnd(tested(nowhere), "Host name", "No machine is known by the host name of this archive.");
    const QrArchive server({.arguments = {"--disable-get"}});
    expectEnd(tested(peerAt(server.port(), "OTHER")), "AE titles",
              "The archive does not go by the AE title OTHER.");
    expectEnd(tested(peerAt(server.port(), server.title())), "Retrieval",
              "The archive can only send to a receiver, and this program has none set up.");
    DimsePeer moves = peerAt(server.port(), server.title());
    moves.receiverPort = 11112;
    expectAllPassed(tested(moves), 6);
    const StoreServer store;
    expectEnd(tested(peerAt(store.port(), store.title())), "Search",
              "The archive does not let this program search.");
}

TEST(DimseConnection, RejectionsAreSaidPlainly) {
    struct Case {
        unsigned char source;
        unsigned char reason;
        const char* said;
    };
    for (const Case& each : {Case{1, 1, "The archive refused the connection without a reason."},
                             Case{1, 3, "The archive does not know this program by the AE title MACULA."},
                             Case{1, 7, "The archive does not go by the AE title HOSTILE."},
                             Case{2, 2, "The archive does not speak this version of the DICOM protocol."},
                             Case{3, 1, "The archive is busy and takes no more connections now."},
                             Case{3, 2, "The archive has as many connections as it allows."},
                             Case{9, 99, "The archive refused the connection without a reason."}}) {
        const HostilePeer peer([&](HostileLine& line) {
            line.receivePdu();
            line.sendPdu(3, {0, 1, each.source, each.reason});
            line.receivePdu();
        });
        expectEnd(tested(peerAt(peer.port(), "HOSTILE")), "AE titles", each.said);
    }
}

// Orthanc behind TLS.
class DimseTls : public testing::Test {
  protected:
    DimsePeer protectedPeer(const Orthanc& server) const {
        DimsePeer peer = peerAt(server.dicomPort(), server.title());
        peer.tls = {.isOn = true, .authorities = authority.file()};
        return peer;
    }
    TemporaryFolder folder;
    Authority authority{folder.path()};
};

TEST_F(DimseTls, TrustedArchivesPass) {
    SKIP_WITHOUT_PROGRAM("Orthanc");
    const Orthanc server({.dicomTls = authority.sign("server")});
    expectAllPassed(tested(protectedPeer(server)), 7);
    const SmallStudy study;
    const auto files = writeStudy(folder.path(), study);
    std::vector<std::filesystem::path> paths;
    for (const auto& [uid, file] : files) paths.push_back(file);
    const auto archive = archiveAt(protectedPeer(server));
    Progress progress;
    const auto sent = archive->send(paths, progress);
    ASSERT_TRUE(sent) << told(sent.error());
    EXPECT_EQ(sent->stored, 6u);
    FolderReceiver receiver;
    const auto fetched = archive->fetch({.studyInstanceUid = study.studyUid}, receiver, progress);
    ASSERT_TRUE(fetched) << told(fetched.error());
    expectSameDatasets(receiver.files(), files);
}

TEST_F(DimseTls, OursIsShown) {
    SKIP_WITHOUT_PROGRAM("Orthanc");
    const Orthanc server({.dicomTls = authority.sign("server"), .trusted = authority.file()});
    DimsePeer peer = protectedPeer(server);
    const std::vector<TestStep> without = tested(peer);
    EXPECT_FALSE(without.back().passed) << told(without);
    const Certificate ours = authority.sign("ours", {.keyPassphrase = "open sesame"});
    peer.tls.certificate = ours.certificate;
    peer.tls.key = ours.key;
    Secrets secrets;
    secrets.keyPassphrase = "open sesame";
    expectAllPassed(tested(peer, secrets), 7);
    secrets.keyPassphrase = "wrong";
    expectEnd(tested(peer, secrets), "Protected connection",
              "The key of this program's certificate cannot be read.");
    peer.tls.key = authority.sign("another").key;
    expectEnd(tested(peer), "Protected connection", "The key does not belong to this program's certificate.");
}

TEST_F(DimseTls, BadCertificatesAreRefused) {
    SKIP_WITHOUT_PROGRAM("Orthanc");
    const std::string step = "Protected connection";
    {
        const Orthanc server({.dicomTls = authority.sign("old", {.isExpired = true})});
        expectEnd(tested(protectedPeer(server)), step, "The certificate of the archive has expired.");
    }
    {
        const Orthanc server({.dicomTls = authority.sign("other", {.host = "pacs.example.org"})});
        expectEnd(tested(protectedPeer(server)), step,
                  "The certificate of the archive is for another host name.");
    }
    const Orthanc server({.dicomTls = authority.sign("server")});
    {
        const TemporaryFolder elsewhere;
        const Authority stranger(elsewhere.path());
        DimsePeer peer = protectedPeer(server);
        peer.tls.authorities = stranger.file();
        expectEnd(tested(peer), step,
                  "The certificate of the archive is signed by nobody whom this machine trusts.");
        peer.tls.authorities.clear();  // those of the system
        expectEnd(tested(peer), step,
                  "The certificate of the archive is signed by nobody whom this machine trusts.");
        peer.tls.authorities = elsewhere / "missing.pem";
        expectEnd(tested(peer), step,
                  "The certificates of the authorities that are to be trusted cannot be read.");
    }
    // Without TLS, where the archive wants it.
    const std::vector<TestStep> steps = tested(peerAt(server.dicomPort(), server.title()));
    EXPECT_FALSE(steps.back().passed);
    EXPECT_EQ(steps.back().name.english(), "AE titles") << told(steps);
}

TEST_F(DimseTls, ArchivesWithoutItAreTold) {
    SKIP_WITHOUT_PROGRAM("Orthanc");
    const Orthanc server;
    const std::vector<TestStep> steps = tested(protectedPeer(server));
    EXPECT_FALSE(steps.back().passed);
    EXPECT_EQ(steps.back().name.english(), "Protected connection") << told(steps);
    const HostilePeer talkative([](HostileLine& line) {
        line.sendAll({'2', '2', '0', ' ', 'h', 'e', 'l', 'l', 'o', '\r', '\n'});
        line.receivePdu();
    });
    DimsePeer peer = protectedPeer(server);
    peer.port = talkative.port();
    expectEnd(tested(peer), "Protected connection", "The archive does not use TLS at this port.");
}

TEST_F(DimseTls, InstancesAreSentToUsProtected) {
    SKIP_WITHOUT_PROGRAM("Orthanc");
    SKIP_WITHOUT_PROGRAM("dcmsend");
    const std::uint16_t receiverPort = freePort();
    const Orthanc server({.known = {},
                          .dicomTls = authority.sign("server"),
                          .trusted = authority.file(),
                          .more = {{"DicomModalities",
                                    {{"RECEIVER",
                                      {{"AET", "RECEIVER"},
                                       {"Host", "127.0.0.1"},
                                       {"Port", receiverPort},
                                       {"UseDicomTls", true}}}}}}});
    DimsePeer peer = protectedPeer(server);
    const Certificate ours = authority.sign("ours");
    peer.tls.certificate = ours.certificate;
    peer.tls.key = ours.key;
    peer.retrieve = Retrieve::move;
    peer.receiverAe = "RECEIVER";
    peer.receiverPort = receiverPort;
    peer.receiverAddress = "127.0.0.1";
    const SmallStudy study;
    const auto files = writeStudy(folder.path(), study);
    std::vector<std::filesystem::path> paths;
    for (const auto& [uid, file] : files) paths.push_back(file);
    const auto archive = archiveAt(peer);
    Progress progress;
    ASSERT_TRUE(archive->send(paths, progress));
    FolderReceiver receiver;
    const auto fetched = archive->fetch({.studyInstanceUid = study.studyUid}, receiver, progress);
    ASSERT_TRUE(fetched) << told(fetched.error()) << server.output();
    expectSameDatasets(receiver.files(), files);
}

TEST(DimseSettings, ThoseThatCannotWorkAreRefused) {
    const auto isRefused = [](const std::function<void(DimsePeer&)>& change) {
        Source source;
        DimsePeer peer = peerAt(104, "ARCHIVE");
        change(peer);
        source.peer = peer;
        const auto archive = archiveOf(source, {});
        if (archive) return false;
        EXPECT_EQ(archive.error().code, ErrorCode::usage);
        EXPECT_FALSE(archive.error().hint.empty());
        return true;
    };
    EXPECT_FALSE(isRefused([](DimsePeer&) {}));
    EXPECT_TRUE(isRefused([](DimsePeer& peer) { peer.host.clear(); }));
    EXPECT_TRUE(isRefused([](DimsePeer& peer) { peer.host = "http://pacs"; }));
    EXPECT_TRUE(isRefused([](DimsePeer& peer) { peer.port = 0; }));
    EXPECT_TRUE(isRefused([](DimsePeer& peer) { peer.calledAe.clear(); }));
    EXPECT_TRUE(isRefused([](DimsePeer& peer) { peer.calledAe = "SEVENTEEN_LETTERS"; }));
    EXPECT_FALSE(isRefused([](DimsePeer& peer) { peer.calledAe = "SIXTEEN_LETTERS_"; }));
    EXPECT_TRUE(isRefused([](DimsePeer& peer) { peer.callingAe = "A\\B"; }));
    EXPECT_TRUE(isRefused([](DimsePeer& peer) { peer.callingAe = "  "; }));
    EXPECT_TRUE(isRefused([](DimsePeer& peer) { peer.receiverAe = "SEVENTEEN_LETTERS"; }));
    EXPECT_TRUE(isRefused([](DimsePeer& peer) { peer.retrieve = Retrieve::move; }));
    EXPECT_TRUE(isRefused([](DimsePeer& peer) { peer.tls.key = "key.pem"; }));
}

}  // namespace

}  // namespace macula::net::test
