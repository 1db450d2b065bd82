// Fetching studies, against DCMTK's archive and Orthanc.
#include <gtest/gtest.h>

#include <algorithm>
#include <future>

#include "net/dimse_support.h"
#include "net/servers.h"

namespace macula::net::test {

namespace {

using dicom::test::TemporaryFolder;
using Files = std::map<std::string, std::filesystem::path>;

Files fillWith(const TemporaryFolder& folder, const SmallStudy& study, std::uint16_t port,
               const std::string& title) {
    Files files = writeStudy(folder.path(), study);
    sendFolder(folder.path(), port, title);
    return files;
}

Fetched fetched(Archive& archive, const Wanted& wanted, Receiver& receiver) {
    Progress progress;
    const Result<Fetched> result = archive.fetch(wanted, receiver, progress);
    EXPECT_TRUE(result) << told(result.error());
    return result ? *result : Fetched{};
}

void expectWhole(const Fetched& result, std::size_t count) {
    EXPECT_EQ(result.promised, count);
    EXPECT_EQ(result.kept, count);
    EXPECT_EQ(result.hadAlready, 0u);
    EXPECT_EQ(result.refused, 0u);
    EXPECT_TRUE(result.never.empty());
    EXPECT_GT(result.bytes, 512u * count);
}

// All of it, a part of it, and the rest.
void expectFetches(Archive& archive, const SmallStudy& study, const Files& files) {
    {
        FolderReceiver receiver;
        expectWhole(fetched(archive, {.studyInstanceUid = study.studyUid}, receiver), files.size());
        expectSameDatasets(receiver.files(), files);
        for (const InstanceKey& key : receiver.promises()) {
            EXPECT_EQ(key.studyInstanceUid, study.studyUid);
            EXPECT_TRUE(key.sopInstanceUid.starts_with(key.seriesInstanceUid + ".")) << key.seriesInstanceUid;
        }
    }
    {
        FolderReceiver receiver;
        const Wanted wanted{.studyInstanceUid = study.studyUid,
                            .seriesInstanceUids = {seriesUidOf(study, 1)}};
        expectWhole(fetched(archive, wanted, receiver), static_cast<std::size_t>(study.slices));
        for (const auto& [uid, file] : receiver.files())
            EXPECT_TRUE(uid.starts_with(seriesUidOf(study, 1) + ".")) << uid;
    }
    {
        // One instance of the first series is there, and all of the second: only what is missing comes.
        FolderReceiver receiver;
        Wanted wanted{.studyInstanceUid = study.studyUid};
        Files missing = files;
        for (const auto& [uid, file] : files) {
            if (uid != seriesUidOf(study, 0) + ".1" && !uid.starts_with(seriesUidOf(study, 1) + "."))
                continue;
            wanted.sopInstancesHad.insert(uid);
            missing.erase(uid);
        }
        const Fetched result = fetched(archive, wanted, receiver);
        EXPECT_EQ(result.promised, files.size());
        EXPECT_EQ(result.kept, missing.size());
        EXPECT_EQ(result.hadAlready, wanted.sopInstancesHad.size());
        EXPECT_EQ(receiver.promises().size(), missing.size());
        expectSameDatasets(receiver.files(), missing);
    }
}

TEST(DimseFetch, GetsFromDcmtksArchive) {
    SKIP_WITHOUT_PROGRAM("dcmqrscp");
    SKIP_WITHOUT_PROGRAM("dcmsend");
    const TemporaryFolder folder;
    const SmallStudy study;
    const QrArchive server;
    const Files files = fillWith(folder, study, server.port(), server.title());
    for (const bool patientRoot : {false, true}) {
        DimsePeer peer = peerAt(server.port(), server.title());
        peer.patientRoot = patientRoot;
        const auto archive = archiveAt(peer);
        Progress progress;
        ASSERT_TRUE(archive->findStudies({.patientId = "P1"}, progress));
        expectFetches(*archive, study, files);
    }
}

TEST(DimseFetch, GetsFromOrthanc) {
    SKIP_WITHOUT_PROGRAM("Orthanc");
    SKIP_WITHOUT_PROGRAM("dcmsend");
    const TemporaryFolder folder;
    const SmallStudy study;
    const Orthanc server;
    const Files files = fillWith(folder, study, server.dicomPort(), server.title());
    expectFetches(*archiveAt(peerAt(server.dicomPort(), server.title())), study, files);
}

DimsePeer receivingPeer(std::uint16_t port, const std::string& title, std::uint16_t receiverPort) {
    DimsePeer peer = peerAt(port, title);
    peer.receiverAe = "RECEIVER";
    peer.receiverPort = receiverPort;
    peer.receiverAddress = "127.0.0.1";
    return peer;
}

TEST(DimseFetch, IsSentTo) {
    SKIP_WITHOUT_PROGRAM("dcmqrscp");
    SKIP_WITHOUT_PROGRAM("Orthanc");
    SKIP_WITHOUT_PROGRAM("dcmsend");
    const SmallStudy study;
    const std::uint16_t receiverPort = freePort();
    const TemporaryFolder folder;
    {
        // It has no C-GET: the way is found by itself.
        const QrArchive server({.known = {{"RECEIVER", receiverPort}}, .arguments = {"--disable-get"}});
        const Files files = fillWith(folder, study, server.port(), server.title());
        expectFetches(*archiveAt(receivingPeer(server.port(), server.title(), receiverPort)), study, files);
    }
    {
        const Orthanc server({.known = {{"RECEIVER", receiverPort}}});
        const Files files = fillWith(folder, study, server.dicomPort(), server.title());
        DimsePeer peer = receivingPeer(server.dicomPort(), server.title(), receiverPort);
        peer.retrieve = Retrieve::move;
        expectFetches(*archiveAt(peer), study, files);
    }
    EXPECT_FALSE(answersAt(receiverPort)) << "it listens after the fetch";
}

TEST(DimseFetch, OrthancSendsInTheBackground) {
    SKIP_WITHOUT_PROGRAM("Orthanc");
    SKIP_WITHOUT_PROGRAM("dcmsend");
    const SmallStudy study;
    const TemporaryFolder folder;
    const std::uint16_t receiverPort = freePort();
    const Orthanc server({.known = {{"RECEIVER", receiverPort}}, .more = {{"SynchronousCMove", false}}});
    const Files files = fillWith(folder, study, server.dicomPort(), server.title());
    DimsePeer peer = receivingPeer(server.dicomPort(), server.title(), receiverPort);
    peer.retrieve = Retrieve::move;
    expectFetches(*archiveAt(peer), study, files);
}

TEST(DimseFetch, SeveralAtOnceShareTheReceiversPort) {
    SKIP_WITHOUT_PROGRAM("dcmqrscp");
    SKIP_WITHOUT_PROGRAM("dcmsend");
    const std::uint16_t receiverPort = freePort();
    const QrArchive server({.known = {{"RECEIVER", receiverPort}}});
    const TemporaryFolder folder;
    const SmallStudy first;
    const SmallStudy second{.studyUid = "2.25.77009", .patientId = "P9"};
    const Files firstFiles = writeStudy(folder / "a", first);
    const Files secondFiles = writeStudy(folder / "b", second);
    sendFolder(folder.path(), server.port(), server.title());
    DimsePeer peer = receivingPeer(server.port(), server.title(), receiverPort);
    peer.retrieve = Retrieve::move;
    const auto archive = archiveAt(peer);
    FolderReceiver firstReceiver;
    FolderReceiver secondReceiver;
    auto other = std::async(std::launch::async, [&] {
        return fetched(*archive, {.studyInstanceUid = second.studyUid}, secondReceiver);
    });
    expectWhole(fetched(*archive, {.studyInstanceUid = first.studyUid}, firstReceiver), firstFiles.size());
    expectWhole(other.get(), secondFiles.size());
    expectSameDatasets(firstReceiver.files(), firstFiles);
    expectSameDatasets(secondReceiver.files(), secondFiles);
}

TEST(DimseFetch, SaysWhatToSetUpOnBothSides) {
    SKIP_WITHOUT_PROGRAM("dcmqrscp");
    SKIP_WITHOUT_PROGRAM("dcmsend");
    const SmallStudy study;
    const TemporaryFolder folder;
    const std::uint16_t receiverPort = freePort();
    const QrArchive server({.arguments = {"--disable-get"}});
    fillWith(folder, study, server.port(), server.title());
    Progress progress;
    FolderReceiver receiver;
    const auto noPort = archiveAt(peerAt(server.port(), server.title()))
                            ->fetch({.studyInstanceUid = study.studyUid}, receiver, progress);
    ASSERT_FALSE(noPort);
    EXPECT_EQ(noPort.error().code, ErrorCode::archiveNotUsable);
    EXPECT_NE(noPort.error().hint.english().find("receiver"), std::string::npos) << told(noPort.error());
    // The archive does not know the receiver.
    const auto unknown = archiveAt(receivingPeer(server.port(), server.title(), receiverPort))
                             ->fetch({.studyInstanceUid = study.studyUid}, receiver, progress);
    ASSERT_FALSE(unknown);
    EXPECT_NE(unknown.error().message.english().find("A801"), std::string::npos) << told(unknown.error());
    EXPECT_TRUE(receiver.files().empty());
}

TEST(DimseFetch, EncodingsAreNotChanged) {
    SKIP_WITHOUT_PROGRAM("Orthanc");
    SKIP_WITHOUT_PROGRAM("dcmcjpeg");
    SKIP_WITHOUT_PROGRAM("dcmcjpls");
    SKIP_WITHOUT_PROGRAM("dcmcrle");
    const TemporaryFolder folder;
    const TemporaryFolder plain;
    SmallStudy study{.seriesCount = 1, .slices = 4};
    const Files plainFiles = writeStudy(plain.path(), study);
    std::vector<std::vector<std::string>> commands{{programNamed("dcmcjpeg"), "+e1"},
                                                   {programNamed("dcmcjpls")},
                                                   {programNamed("dcmcrle")},
                                                   {programNamed("dcmconv"), "+ti"}};
    Files files;
    std::size_t i = 0;
    for (const auto& [uid, file] : plainFiles) {
        std::vector<std::string> command = commands[i];
        files[uid] = folder / (std::to_string(i++) + ".dcm");
        command.push_back(file.string());
        command.push_back(files[uid].string());
        const Ran changed = ran(command, plain.path());
        ASSERT_EQ(changed.exitCode, 0) << changed.output;
    }
    const Orthanc server;
    const auto archive = archiveAt(peerAt(server.dicomPort(), server.title()));
    // DCMTK's dcmsend would change what is not compressed.
    std::vector<std::filesystem::path> paths;
    for (const auto& [uid, file] : files) paths.push_back(file);
    Progress progress;
    const auto sent = archive->send(paths, progress);
    ASSERT_TRUE(sent) << told(sent.error());
    FolderReceiver receiver;
    expectWhole(fetched(*archive, {.studyInstanceUid = study.studyUid}, receiver), 4);
    expectSameDatasets(receiver.files(), files);
}

// dcmqrscp with these arguments prefers one encoding for all, and can change none.
TEST(DimseFetch, AnArchiveThatChoosesOneEncodingForAllIsAskedAgain) {
    SKIP_WITHOUT_PROGRAM("dcmqrscp");
    SKIP_WITHOUT_PROGRAM("dcmcjpeg");
    const TemporaryFolder folder;
    const SmallStudy study{.seriesCount = 1, .slices = 4};
    Files files = writeStudy(folder / "plain", study);
    const auto compressed = folder / "compressed";
    const auto original = std::next(files.begin());
    const TemporaryFolder own;
    const Ran changed =
        ran({programNamed("dcmcjpeg"), original->second.string(), compressed.string()}, own.path());
    ASSERT_EQ(changed.exitCode, 0) << changed.output;
    std::filesystem::rename(compressed, original->second);
    const std::uint16_t receiverPort = freePort();
    const QrArchive server({.known = {{"MACULA", receiverPort}}, .arguments = {"+xs", "-xs"}});
    sendFolder(folder / "plain", server.port(), server.title());
    for (const Retrieve way : {Retrieve::get, Retrieve::move}) {
        DimsePeer peer = peerAt(server.port(), server.title());
        peer.retrieve = way;
        peer.receiverPort = receiverPort;
        FolderReceiver receiver;
        const Fetched result = fetched(*archiveAt(peer), {.studyInstanceUid = study.studyUid}, receiver);
        EXPECT_EQ(result.kept, files.size()) << server.output();
        EXPECT_TRUE(result.never.empty());
        expectSameDatasets(receiver.files(), files);
    }
}

TEST(DimseFetch, StopsWhenTheReceiverIsFull) {
    SKIP_WITHOUT_PROGRAM("Orthanc");
    SKIP_WITHOUT_PROGRAM("dcmsend");
    const TemporaryFolder folder;
    const SmallStudy study;
    const Orthanc server;
    fillWith(folder, study, server.dicomPort(), server.title());
    FolderReceiver receiver;
    receiver.fullAfter = 2;
    Progress progress;
    const auto archive = archiveAt(peerAt(server.dicomPort(), server.title()));
    const auto result = archive->fetch({.studyInstanceUid = study.studyUid}, receiver, progress);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::outputNotWritable);
    EXPECT_EQ(receiver.files().size(), 2u);
}

TEST(DimseFetch, LeavesOutWhatIsTooLargeOrRefused) {
    SKIP_WITHOUT_PROGRAM("Orthanc");
    SKIP_WITHOUT_PROGRAM("dcmsend");
    const TemporaryFolder folder;
    const SmallStudy study;
    const Orthanc server;
    const Files files = fillWith(folder, study, server.dicomPort(), server.title());
    const auto archive = archiveAt(peerAt(server.dicomPort(), server.title()));
    {
        FolderReceiver receiver;
        receiver.refuses = {files.begin()->first};
        const Fetched result = fetched(*archive, {.studyInstanceUid = study.studyUid}, receiver);
        EXPECT_EQ(result.kept, 5u);
        EXPECT_EQ(result.refused, 1u);
        EXPECT_TRUE(result.never.empty());
    }
    {
        FolderReceiver receiver(600);  // no instance is that small
        const Fetched result = fetched(*archive, {.studyInstanceUid = study.studyUid}, receiver);
        EXPECT_EQ(result.kept, 0u);
        EXPECT_EQ(result.refused, 6u);
        EXPECT_EQ(receiver.filesInFolder(), 0u) << "a file was left";
    }
}

TEST(DimseFetch, CancelKeepsWhatCame) {
    SKIP_WITHOUT_PROGRAM("Orthanc");
    SKIP_WITHOUT_PROGRAM("dcmsend");
    const TemporaryFolder folder;
    const SmallStudy study{.seriesCount = 1, .slices = 40};
    const std::uint16_t receiverPort = freePort();
    const Orthanc server({.known = {{"RECEIVER", receiverPort}}});
    fillWith(folder, study, server.dicomPort(), server.title());
    for (const Retrieve way : {Retrieve::get, Retrieve::move}) {
        DimsePeer peer = receivingPeer(server.dicomPort(), server.title(), receiverPort);
        peer.retrieve = way;
        FolderReceiver receiver;
        receiver.cancels = true;
        Progress progress({}, receiver.cancelsAfterFirst);
        const auto begin = std::chrono::steady_clock::now();
        const auto result = archiveAt(peer)->fetch({.studyInstanceUid = study.studyUid}, receiver, progress);
        ASSERT_FALSE(result);
        EXPECT_EQ(result.error().code, ErrorCode::cancelled) << told(result.error());
        EXPECT_GE(receiver.files().size(), 1u);
        EXPECT_EQ(receiver.filesInFolder(), receiver.files().size()) << "a part of an instance was left";
        EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30));
    }
}

TEST(DimseFetch, SaysWhenThereIsNothing) {
    SKIP_WITHOUT_PROGRAM("Orthanc");
    const Orthanc server;
    FolderReceiver receiver;
    Progress progress;
    const auto archive = archiveAt(peerAt(server.dicomPort(), server.title()));
    const auto result = archive->fetch({.studyInstanceUid = "2.25.99"}, receiver, progress);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::archiveNotUsable);
    EXPECT_FALSE(result.error().hint.empty());
}

}  // namespace

}  // namespace macula::net::test
