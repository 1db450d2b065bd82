// Archives that list what they have, well or badly, before they send it.
#include <gtest/gtest.h>

#include <atomic>
#include <functional>

#include "net/dimse_support.h"
#include "net/hostile_peer.h"

namespace macula::net::test {

namespace {

const std::string kCtOfLists = "1.2.840.10008.5.1.4.1.1.2";
const std::string kMrOfLists = "1.2.840.10008.5.1.4.1.1.4";
using Received = HostileLine::Received;

Bytes seriesAnswer(const std::string& uid, const std::string& modality = "CT") {
    return joined({explicitElement(0x00080052, "CS", "SERIES"), explicitElement(0x00080060, "CS", modality),
                   explicitElement(0x0020000e, "UI", uid)});
}

Bytes imageAnswer(const std::string& uid) {
    return joined({explicitElement(0x00080016, "UI", kCtOfLists), explicitElement(0x00080018, "UI", uid),
                   explicitElement(0x00080052, "CS", "IMAGE")});
}

void answerAll(HostileLine& line, const Received& request, const std::vector<Bytes>& answers,
               std::uint16_t status = 0) {
    for (const Bytes& each : answers) {
        line.sendCommand(request.context, {.field = CommandField::findResponse,
                                           .respondsTo = request.command.messageId,
                                           .status = std::uint16_t{0xff00},
                                           .hasDataset = true});
        line.sendFragment(request.context, false, true, each);
    }
    line.sendCommand(
        request.context,
        {.field = CommandField::findResponse, .respondsTo = request.command.messageId, .status = status});
}

// The status of the answer; nothing if the connection has ended.
std::optional<std::uint16_t> stored(HostileLine& line, const std::string& uid,
                                    const std::string& study = "2.25.1") {
    const unsigned context = line.contextOf(kCtOfLists);
    line.sendCommand(context, {.field = CommandField::storeRequest,
                               .messageId = std::uint16_t{7},
                               .sopClassUid = kCtOfLists,
                               .sopInstanceUid = uid,
                               .hasDataset = true});
    line.sendFragment(
        context, false, true,
        joined({explicitElement(0x00080016, "UI", kCtOfLists), explicitElement(0x00080018, "UI", uid),
                explicitElement(0x0020000d, "UI", study)}));
    const auto response = line.receiveCommand();
    return response ? response->command.status : std::nullopt;
}

void endGet(HostileLine& line, const Received& request, std::uint16_t status = 0) {
    line.sendCommand(
        request.context,
        {.field = CommandField::getResponse, .respondsTo = request.command.messageId, .status = status});
}

// Each C-FIND goes to `find`, with a number from 0 over all connections, and each C-GET to `get`. Whatever
// returns false closes the connection.
struct ListingPeer {
    using Find = std::function<bool(HostileLine&, const Received&, int)>;
    using Get = std::function<bool(HostileLine&, const Received&)>;
    ListingPeer(Find find, Get get)
        : peer([this, find = std::move(find), get = std::move(get)](HostileLine& line) {
              if (!line.acceptAssociation()) return;
              while (const auto request = line.receiveCommand()) {
                  if (request->command.field == CommandField::findRequest && !find(line, *request, finds++))
                      return;
                  if (request->command.field == CommandField::getRequest && !get(line, *request)) return;
              }
          }) {}
    Result<Fetched> fetch(const Wanted& wanted = {.studyInstanceUid = "2.25.1"}) {
        DimsePeer settings = peerAt(peer.port(), "HOSTILE");
        settings.retrieve = Retrieve::get;
        Progress progress;
        return archiveAt(settings, {}, std::chrono::seconds(5))->fetch(wanted, receiver, progress);
    }
    std::atomic<int> finds{0};
    FolderReceiver receiver{100000};
    HostilePeer peer;
};

bool sendsOne(HostileLine& line, const Received& request) {
    stored(line, "2.25.1.1.1");
    endGet(line, request);
    return true;
}

TEST(DimseLists, AWholeListIsWhole) {
    ListingPeer peer(
        [](HostileLine& line, const Received& request, int number) {
            answerAll(line, request, {number == 0 ? seriesAnswer("2.25.1.1") : imageAnswer("2.25.1.1.1")});
            return true;
        },
        sendsOne);
    const auto result = peer.fetch();
    ASSERT_TRUE(result) << told(result.error());
    EXPECT_TRUE(result->isListWhole);
    EXPECT_EQ(result->promised, 1u);
    EXPECT_EQ(result->kept, 1u);
}

TEST(DimseLists, AnUnusableAnswerMakesTheListIncomplete) {
    for (const bool ofSeries : {true, false}) {
        ListingPeer peer(
            [&](HostileLine& line, const Received& request, int number) {
                std::vector<Bytes> answers{number == 0 ? seriesAnswer("2.25.1.1")
                                                       : imageAnswer("2.25.1.1.1")};
                if (ofSeries == (number == 0))
                    answers.push_back(ofSeries ? seriesAnswer("") : imageAnswer(""));
                answerAll(line, request, answers);
                return true;
            },
            sendsOne);
        const auto result = peer.fetch();
        ASSERT_TRUE(result) << told(result.error());
        EXPECT_EQ(result->kept, 1u);
        EXPECT_FALSE(result->isListWhole) << ofSeries;
    }
}

TEST(DimseLists, AListThatBreaksIsAskedForAgain) {
    ListingPeer peer(
        [](HostileLine& line, const Received& request, int number) {
            if (number == 1) return false;  // in the middle
            answerAll(line, request,
                      {number % 2 == 0 ? seriesAnswer("2.25.1.1") : imageAnswer("2.25.1.1.1")});
            return true;
        },
        sendsOne);
    const auto result = peer.fetch();
    ASSERT_TRUE(result) << told(result.error());
    EXPECT_EQ(peer.finds, 4);
    EXPECT_TRUE(result->isListWhole);
    EXPECT_EQ(result->promised, 1u);
}

TEST(DimseLists, AListThatAlwaysBreaksIsAnError) {
    ListingPeer peer([](HostileLine&, const Received&, int) { return false; }, sendsOne);
    const auto result = peer.fetch();
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::archiveNotUsable);
    EXPECT_EQ(peer.finds, 4) << "once, and three times more";
}

TEST(DimseLists, AllModalitiesAreExpectedWithoutInstances) {
    std::atomic<bool> takesMr{false};
    ListingPeer peer(
        [](HostileLine& line, const Received& request, int number) {
            if (number == 0)
                answerAll(line, request, {seriesAnswer("2.25.1.1"), seriesAnswer("2.25.1.2", "MR")});
            else
                answerAll(line, request, {}, 0xa900);
            return true;
        },
        [&](HostileLine& line, const Received& request) {
            takesMr = line.contextOf(kMrOfLists) != 0;
            return sendsOne(line, request);
        });
    const auto result = peer.fetch();
    ASSERT_TRUE(result) << told(result.error());
    EXPECT_TRUE(takesMr) << "the modality of the second series";
    EXPECT_FALSE(result->isListWhole);
}

TEST(DimseLists, WhatWasThereAndComesAgainCountsOnce) {
    ListingPeer peer(
        [](HostileLine& line, const Received& request, int number) {
            if (number == 0)
                answerAll(line, request, {seriesAnswer("2.25.1.1")});
            else
                answerAll(line, request, {imageAnswer("2.25.1.1.1"), imageAnswer("2.25.1.1.2")});
            return true;
        },
        [](HostileLine& line, const Received& request) {
            for (const char* uid : {"2.25.1.1.1", "2.25.1.1.2", "2.25.1.1.1"}) stored(line, uid);
            endGet(line, request);
            return true;
        });
    const auto result = peer.fetch({.studyInstanceUid = "2.25.1", .sopInstancesHad = {"2.25.1.1.1"}});
    ASSERT_TRUE(result) << told(result.error());
    EXPECT_EQ(result->promised, 2u);
    EXPECT_EQ(result->hadAlready, 1u);
}

TEST(DimseLists, ARefusedInstanceIsOneStep) {
    std::atomic<int> tries{0};
    ListingPeer peer(
        [](HostileLine& line, const Received& request, int number) {
            if (number == 0)
                answerAll(line, request, {seriesAnswer("2.25.1.1")});
            else
                answerAll(line, request, {imageAnswer("2.25.1.1.1"), imageAnswer("2.25.1.1.2")});
            return true;
        },
        [&](HostileLine& line, const Received&) {
            // Of another study: it is refused each time, and the other one never comes.
            if (++tries <= 20) stored(line, "2.25.1.1.1", "2.25.6");
            return false;
        });
    EXPECT_FALSE(peer.fetch());
    EXPECT_LE(tries, 5);
}

TEST(DimseLists, AFloodOfInstancesEnds) {
    std::atomic<int> sent{0};
    ListingPeer peer(
        [](HostileLine& line, const Received& request, int number) {
            answerAll(line, request, {number == 0 ? seriesAnswer("2.25.1.1") : imageAnswer("2.25.1.1.1")});
            return true;
        },
        [&](HostileLine& line, const Received& request) {
            for (int i = 0; i < 3000; ++i) {
                if (!stored(line, "2.25.6." + std::to_string(i), "2.25.6")) return false;
                ++sent;
            }
            endGet(line, request);
            return true;
        });
    const auto result = peer.fetch();
    ASSERT_FALSE(result);
    EXPECT_LT(sent, 1100);
    EXPECT_EQ(result.error().message.english(), "The archive sends far more instances than it says it has.");
}

TEST(DimseLists, MorePatientsThanAreAskedForAreCutShort) {
    ListingPeer peer(
        [](HostileLine& line, const Received& request, int number) {
            std::vector<Bytes> answers;
            for (int i = 0; number == 0 && i < 1001; ++i)
                answers.push_back(explicitElement(0x00100020, "LO", "P" + std::to_string(i)));
            if (number > 0)
                answers.push_back(explicitElement(0x0020000d, "UI", "2.25.1." + std::to_string(number)));
            answerAll(line, request, answers);
            return true;
        },
        sendsOne);
    DimsePeer settings = peerAt(peer.peer.port(), "HOSTILE");
    settings.patientRoot = true;
    Progress progress;
    const auto answers = archiveAt(settings)->findStudies({.patientName = "A*", .mostAnswers = 3}, progress);
    ASSERT_TRUE(answers) << told(answers.error());
    EXPECT_EQ(answers->studies.size(), 3u);
    EXPECT_TRUE(answers->isCutShort);
}

}  // namespace

}  // namespace macula::net::test
