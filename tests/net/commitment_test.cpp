// Storage commitment: Orthanc, which offers it, DCMTK's archive, which does not, and one that breaks rules.
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <thread>

#include "net/dimse/commitment_dataset.h"
#include "net/dimse/contexts.h"
#include "net/dimse_support.h"
#include "net/hostile_peer.h"
#include "net/servers.h"

namespace macula::net::test {

namespace {

using dicom::test::TemporaryFolder;
using Paths = std::vector<std::filesystem::path>;
using State = Commitment::State;

const std::string kCommitmentClass{kCommitment};

class CommitmentTest : public testing::Test {
  protected:
    CommitmentTest() {
        for (const auto& [uid, file] : writeStudy(folder_.path(), {.seriesCount = 1})) {
            files_.push_back(file);
            uids_.push_back(uid);
        }
    }
    Result<std::vector<Commitment>> commit(const DimsePeer& peer, int seconds = 20) {
        Progress progress;
        return archiveAt(peer)->commit(files_, std::chrono::seconds(seconds), progress);
    }
    void expectAll(const Result<std::vector<Commitment>>& commitments, State state) {
        ASSERT_TRUE(commitments) << told(commitments.error());
        ASSERT_EQ(commitments->size(), files_.size());
        for (std::size_t i = 0; i < files_.size(); ++i) {
            const Commitment& each = (*commitments)[i];
            EXPECT_EQ(each.file, files_[i]);
            EXPECT_EQ(each.state, state) << each.why;
            EXPECT_EQ(each.why.empty(), state == State::committed);
            EXPECT_EQ(each.advice.empty(), state == State::committed);
        }
    }

    TemporaryFolder folder_;
    Paths files_;
    std::vector<std::string> uids_;
};

TEST_F(CommitmentTest, OrthancConfirmsWhatItHas) {
    SKIP_WITHOUT_PROGRAM("Orthanc");
    const std::uint16_t receiverPort = freePort();
    const Orthanc server({.known = {{"MACULA", receiverPort}}});
    DimsePeer peer = peerAt(server.dicomPort(), server.title());
    peer.receiverPort = receiverPort;
    peer.receiverAddress = "127.0.0.1";
    Progress progress;
    ASSERT_TRUE(archiveAt(peer)->send(std::span(files_).first(2), progress));
    const auto some = commit(peer);
    ASSERT_TRUE(some) << told(some.error()) << server.output();
    ASSERT_EQ(some->size(), 3u);
    EXPECT_EQ((*some)[0].state, State::committed) << (*some)[0].why << server.output();
    EXPECT_EQ((*some)[1].state, State::committed);
    EXPECT_EQ((*some)[2].state, State::refused);
    EXPECT_EQ((*some)[2].why.english(), "The archive does not have this object (reason 0112).");
    EXPECT_FALSE(answersAt(receiverPort)) << "it still listens";
    ASSERT_TRUE(archiveAt(peer)->send(files_, progress));
    expectAll(commit(peer), State::committed);
}

TEST_F(CommitmentTest, WithoutAReceiverOrthancsReportDoesNotCome) {
    SKIP_WITHOUT_PROGRAM("Orthanc");
    const Orthanc server({.known = {{"MACULA", freePort()}}});
    const DimsePeer peer = peerAt(server.dicomPort(), server.title());
    Progress progress;
    ASSERT_TRUE(archiveAt(peer)->send(files_, progress));
    const auto commitments = commit(peer, 1);
    expectAll(commitments, State::unanswered);
    EXPECT_NE(commitments->front().advice.english().find("receiver's port"), std::string::npos);
}

TEST_F(CommitmentTest, WhoDoesNotOfferItIsTold) {
    SKIP_WITHOUT_PROGRAM("dcmqrscp");
    const QrArchive server;
    const auto commitments = commit(peerAt(server.port(), server.title()));
    ASSERT_FALSE(commitments);
    EXPECT_EQ(commitments.error().code, ErrorCode::archiveNotUsable);
    EXPECT_EQ(commitments.error().message.english(),
              "The archive does not confirm what it keeps: it does not offer storage commitment.");
    Source web;
    web.peer = WebPeer{.url = "http://127.0.0.1:1/dicom-web"};
    Progress progress;
    const auto byWeb = (*archiveOf(web, {}))->commit(files_, std::chrono::seconds(1), progress);
    ASSERT_FALSE(byWeb);
    EXPECT_FALSE(byWeb.error().hint.empty());
}

// The dataset behind a request: receiveCommand leaves it on the line.
std::string transactionOf(HostileLine& line) {
    Bytes bytes;
    while (const auto pdu = line.receivePdu()) {
        if (pdu->first != 4 || pdu->second.size() < 6) return {};
        bytes.insert(bytes.end(), pdu->second.begin() + 6, pdu->second.end());
        if ((pdu->second[5] & 2u) != 0) break;
    }
    const auto request = commitmentReportOf(bytes, "1.2.840.10008.1.2.1");
    return request ? request->transactionUid : std::string();
}

void answerAction(HostileLine& line, const HostileLine::Received& request, std::uint16_t status = 0) {
    line.sendCommand(request.context, {.field = CommandField::actionResponse,
                                       .respondsTo = request.command.messageId,
                                       .sopClassUid = kCommitmentClass,
                                       .status = status});
}

// All of them are kept, or a few are not: that is for the sequence to say, as its items are the same.
void sendReport(HostileLine& line, unsigned context, const std::string& transaction,
                const std::vector<std::string>& uids) {
    std::vector<ReferencedInstance> instances;
    for (const std::string& uid : uids) instances.push_back({"1.2.840.10008.5.1.4.1.1.2", uid});
    line.sendCommand(context, {.field = CommandField::eventReportRequest,
                               .messageId = std::uint16_t{7},
                               .sopClassUid = kCommitmentClass,
                               .sopInstanceUid = std::string(kCommitmentInstance),
                               .eventType = std::uint16_t{1},
                               .hasDataset = true});
    const auto bytes = commitmentRequestBytes(transaction, instances, "1.2.840.10008.1.2.1");
    line.sendFragment(context, false, true, bytes);
}

TEST_F(CommitmentTest, AReportOverTheSameAssociationCounts) {
    std::atomic<int> status{-1};
    const HostilePeer peer([&](HostileLine& line) {
        if (!line.acceptAssociation()) return;
        const auto request = line.receiveCommandOf(CommandField::actionRequest);
        if (!request) return;
        EXPECT_EQ(request->command.requestedClassUid, kCommitment);
        EXPECT_EQ(request->command.requestedInstanceUid, kCommitmentInstance);
        EXPECT_EQ(request->command.actionType, 1);
        const std::string transaction = transactionOf(line);
        answerAction(line, *request);
        sendReport(line, request->context, transaction, uids_);
        const auto response = line.receiveCommandOf(CommandField::eventReportResponse);
        if (response) status = response->command.status.value_or(0xffff);
        line.receivePdu();  // of the release
        line.sendPdu(6, Bytes(4));
    });
    expectAll(commit(peerAt(peer.port(), "HOSTILE")), State::committed);
    EXPECT_EQ(status, 0);
}

TEST_F(CommitmentTest, AReportMayOvertakeTheAnswerAndNameOthers) {
    const HostilePeer peer([&](HostileLine& line) {
        if (!line.acceptAssociation()) return;
        const auto request = line.receiveCommandOf(CommandField::actionRequest);
        if (!request) return;
        const std::string transaction = transactionOf(line);
        std::vector<std::string> uids = uids_;
        uids.back() = "2.25.99";  // which nobody asked about
        sendReport(line, request->context, transaction, uids);
        line.receiveCommandOf(CommandField::eventReportResponse);
        answerAction(line, *request);
        line.receivePdu();
        line.sendPdu(6, Bytes(4));
    });
    const auto commitments = commit(peerAt(peer.port(), "HOSTILE"));
    ASSERT_TRUE(commitments) << told(commitments.error());
    EXPECT_EQ(commitments->front().state, State::committed);
    EXPECT_EQ(commitments->back().state, State::unanswered) << "the archive did not mention it";
}

TEST_F(CommitmentTest, ReportsOfOtherTransactionsDoNotCount) {
    std::atomic<int> status{-1};
    const HostilePeer peer([&](HostileLine& line) {
        if (!line.acceptAssociation()) return;
        const auto request = line.receiveCommandOf(CommandField::actionRequest);
        if (!request) return;
        transactionOf(line);
        answerAction(line, *request);
        sendReport(line, request->context, "2.25.123", uids_);
        const auto response = line.receiveCommandOf(CommandField::eventReportResponse);
        if (response) status = response->command.status.value_or(0xffff);
    });
    expectAll(commit(peerAt(peer.port(), "HOSTILE")), State::unanswered);
    EXPECT_EQ(status, 0x0110);
}

TEST_F(CommitmentTest, ARefusalSaysWhatToDo) {
    const HostilePeer peer([&](HostileLine& line) {
        if (!line.acceptAssociation()) return;
        const auto request = line.receiveCommandOf(CommandField::actionRequest);
        if (!request) return;
        transactionOf(line);
        answerAction(line, *request, 0x0124);
        line.receivePdu();
        line.sendPdu(6, Bytes(4));
    });
    const auto commitments = commit(peerAt(peer.port(), "HOSTILE"));
    ASSERT_FALSE(commitments);
    EXPECT_EQ(commitments.error().message.english(),
              "The archive does not allow this program to do this (status 0124).");
}

// The archive reports over connections that it makes, and somebody else meddles.
TEST_F(CommitmentTest, TheReceiverTakesReportsAlone) {
    const std::uint16_t receiverPort = freePort();
    const auto meddle = [&] {
        const auto associates = [&](const std::string& ae, const std::string& sopClass) {
            const int socket = connectionTo(receiverPort);
            HostileLine line(socket);
            const bool isAccepted = line.requestAssociation(ae, sopClass, "1.2.840.10008.1.2.1");
            close(socket);
            return isAccepted;
        };
        EXPECT_FALSE(associates("SOMEBODY", kCommitmentClass));
        EXPECT_FALSE(associates("MACULA", "1.2.840.10008.5.1.4.1.1.2")) << "it stores nothing";
        EXPECT_TRUE(associates("MACULA", kCommitmentClass));
    };
    std::string transaction;
    const HostilePeer peer([&](HostileLine& line) {
        if (!line.acceptAssociation()) return;
        const auto request = line.receiveCommandOf(CommandField::actionRequest);
        if (!request) return;
        transaction = transactionOf(line);
        answerAction(line, *request);
        meddle();
        const int socket = connectionTo(receiverPort);
        HostileLine own(socket);
        EXPECT_TRUE(own.requestAssociation("MACULA", kCommitmentClass, "1.2.840.10008.1.2.1"));
        sendReport(own, 1, transaction, uids_);
        EXPECT_TRUE(own.receiveCommandOf(CommandField::eventReportResponse));
        close(socket);
        line.receivePdu();
        line.sendPdu(6, Bytes(4));
    });
    DimsePeer settings = peerAt(peer.port(), "HOSTILE");
    settings.receiverPort = receiverPort;
    settings.receiverAddress = "127.0.0.1";
    expectAll(commit(settings), State::committed);
    EXPECT_FALSE(answersAt(receiverPort));
}

TEST_F(CommitmentTest, CancelEndsTheWait) {
    const HostilePeer peer([&](HostileLine& line) {
        if (!line.acceptAssociation()) return;
        const auto request = line.receiveCommandOf(CommandField::actionRequest);
        if (!request) return;
        transactionOf(line);
        answerAction(line, *request);
        line.receivePdu();
        line.sendPdu(6, Bytes(4));
    });
    CancelToken cancel;
    Progress progress({}, cancel);
    std::thread canceller([&] {
        comes([&] { return peer.connections() > 0; });
        cancel.cancel();
    });
    const auto commitments =
        archiveAt(peerAt(peer.port(), "HOSTILE"))->commit(files_, std::chrono::seconds(600), progress);
    canceller.join();
    ASSERT_FALSE(commitments);
    EXPECT_EQ(commitments.error().code, ErrorCode::cancelled);
}

}  // namespace

}  // namespace macula::net::test
