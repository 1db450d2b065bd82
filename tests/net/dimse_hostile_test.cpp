// Archives that break rules: nothing crashes, waits past its limits, or writes outside the receiver's files.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <thread>

#include "base/utf8.h"
#include "net/dimse_support.h"
#include "net/hostile_peer.h"
#include "net/programs.h"

namespace macula::net::test {

namespace {

using Clock = std::chrono::steady_clock;

const std::string kFind = "1.2.840.10008.5.1.4.1.2.2.1";
const std::string kGet = "1.2.840.10008.5.1.4.1.2.2.3";
const std::string kCt = "1.2.840.10008.5.1.4.1.1.2";

std::unique_ptr<Archive> hostileArchive(const HostilePeer& peer, int answerSeconds = 2) {
    DimsePeer settings = peerAt(peer.port(), "HOSTILE");
    settings.retrieve = Retrieve::get;
    return archiveAt(settings, {}, std::chrono::seconds(answerSeconds));
}

Bytes studyAnswer(const std::string& uid) {
    return joined({explicitElement(0x00080052, "CS", "STUDY"), explicitElement(0x00100010, "PN", "SOMEBODY"),
                   explicitElement(0x0020000d, "UI", uid)});
}

// Sends an answer to a search.
bool answer(HostileLine& line, const HostileLine::Received& request, const Bytes& identifier) {
    return line.sendCommand(request.context, {.field = CommandField::findResponse,
                                              .respondsTo = request.command.messageId,
                                              .sopClassUid = kFind,
                                              .status = std::uint16_t{0xff00},
                                              .hasDataset = true}) &&
           line.sendFragment(request.context, false, true, identifier);
}

bool lastAnswer(HostileLine& line, const HostileLine::Received& request, CommandField field,
                std::uint16_t status = 0) {
    return line.sendCommand(request.context,
                            {.field = field, .respondsTo = request.command.messageId, .status = status});
}

// A search that the script answers.
Result<StudyAnswers> searched(const std::function<void(HostileLine&, const HostileLine::Received&)>& script,
                              const StudyQuery& query = {}) {
    const HostilePeer peer([&](HostileLine& line) {
        if (!line.acceptAssociation()) return;
        const auto request = line.receiveCommandOf(CommandField::findRequest);
        if (request) script(line, *request);
        while (line.receiveCommand()) continue;
    });
    Progress progress;
    return hostileArchive(peer)->findStudies(query, progress);
}

TEST(DimseHostile, AnswersWithoutUseAreCounted) {
    Bytes wrongLength = studyAnswer("2.25.5");
    wrongLength[6] = 0xff;
    Bytes deep;
    for (int i = 0; i < 20000; ++i) {
        const Bytes sequence{0x08, 0x00, 0x40, 0x11, 'S',  'Q',  0,    0,    0xff, 0xff,
                             0xff, 0xff, 0xfe, 0xff, 0x00, 0xe0, 0xff, 0xff, 0xff, 0xff};
        if (deep.size() < 250000) deep.insert(deep.end(), sequence.begin(), sequence.end());
    }
    const auto answers = searched([&](HostileLine& line, const HostileLine::Received& request) {
        answer(line, request, studyAnswer("2.25.1"));
        answer(line, request, studyAnswer(""));
        answer(line, request, studyAnswer("2.25.2\\2.25.3"));
        answer(line, request, studyAnswer("../../etc/passwd"));
        answer(line, request, wrongLength);
        answer(line, request, deep);
        answer(line, request, Bytes(300000, 'x'));
        answer(line, request, {});
        answer(line, request, studyAnswer("2.25.1"));  // again
        answer(line, request, studyAnswer("2.25.4"));
        lastAnswer(line, request, CommandField::findResponse);
    });
    ASSERT_TRUE(answers) << told(answers.error());
    ASSERT_EQ(answers->studies.size(), 2u);
    EXPECT_EQ(answers->studies[0].studyInstanceUid, "2.25.1");
    EXPECT_EQ(answers->studies[1].studyInstanceUid, "2.25.4");
    EXPECT_EQ(answers->unusable, 7u);
    EXPECT_FALSE(answers->isCutShort);
}

TEST(DimseHostile, TextIsAlwaysUtf8) {
    const auto answers = searched([&](HostileLine& line, const HostileLine::Received& request) {
        answer(line, request,
               joined({explicitElement(0x00080005, "CS", "NO SUCH SET"),
                       explicitElement(0x00081030, "LO", "\xff\xfe\x01\x1b[31m"),
                       explicitElement(0x00100010, "PN", std::string(9000, '\xe4')),
                       explicitElement(0x0020000d, "UI", "2.25.1")}));
        lastAnswer(line, request, CommandField::findResponse);
    });
    ASSERT_TRUE(answers) << told(answers.error());
    ASSERT_EQ(answers->studies.size(), 1u);
    const FoundStudy& study = answers->studies.front();
    EXPECT_EQ(study.description.find('\x1b'), std::string::npos);
    EXPECT_TRUE(isValidUtf8(study.description));
    EXPECT_FALSE(study.description.empty());
    EXPECT_TRUE(isValidUtf8(study.patientName));
    EXPECT_LE(study.patientName.size(), 1024u);
    EXPECT_TRUE(study.patientName.starts_with("ää"));
}

TEST(DimseHostile, AFloodOfAnswersEnds) {
    std::atomic<bool> wasCancelled{false};
    const HostilePeer peer([&](HostileLine& line) {
        if (!line.acceptAssociation()) return;
        const auto request = line.receiveCommandOf(CommandField::findRequest);
        if (!request) return;
        for (int i = 0; answer(line, *request, studyAnswer("2.25.9" + std::to_string(i))); ++i) continue;
        wasCancelled = true;
    });
    Progress progress;
    const auto begin = Clock::now();
    const auto answers = hostileArchive(peer)->findStudies({.mostAnswers = 100}, progress);
    ASSERT_TRUE(answers) << told(answers.error());
    EXPECT_EQ(answers->studies.size(), 100u);
    EXPECT_TRUE(answers->isCutShort);
    EXPECT_LT(Clock::now() - begin, std::chrono::seconds(60));
}

TEST(DimseHostile, AFloodOfUselessAnswersEnds) {
    const HostilePeer peer([&](HostileLine& line) {
        if (!line.acceptAssociation()) return;
        const auto request = line.receiveCommandOf(CommandField::findRequest);
        while (request && answer(line, *request, studyAnswer(""))) continue;
    });
    Progress progress;
    const auto answers = hostileArchive(peer)->findStudies({.mostAnswers = 50}, progress);
    ASSERT_TRUE(answers) << told(answers.error());
    EXPECT_TRUE(answers->studies.empty());
    EXPECT_TRUE(answers->isCutShort);
    EXPECT_GE(answers->unusable, 50u);
}

TEST(DimseHostile, AnEndlessAnswerIsAnError) {
    const auto answers = searched([&](HostileLine& line, const HostileLine::Received& request) {
        line.sendCommand(request.context, {.field = CommandField::findResponse,
                                           .respondsTo = request.command.messageId,
                                           .status = std::uint16_t{0xff00},
                                           .hasDataset = true});
        while (line.sendFragment(request.context, false, false, Bytes(16000, 'x'))) continue;
    });
    ASSERT_FALSE(answers);
    EXPECT_EQ(answers.error().code, ErrorCode::archiveNotUsable);
    const auto commands = searched([&](HostileLine& line, const HostileLine::Received& request) {
        while (line.sendFragment(request.context, true, false, Bytes(16000, 'x'))) continue;
    });
    ASSERT_FALSE(commands);
    EXPECT_EQ(commands.error().code, ErrorCode::archiveNotUsable);
}

TEST(DimseHostile, WhatIsNoDicomIsAnError) {
    const std::vector<std::function<void(HostileLine&)>> scripts{
        [](HostileLine&) {},  // closes
        [](HostileLine& line) { line.sendAll(Bytes(1000, 0xff)); },
        [](HostileLine& line) {
            line.receivePdu();
            line.sendAll(Bytes{'H', 'T', 'T', 'P', '/', '1', '.', '1', ' ', '4', '0', '0', '\r', '\n'});
        },
        [](HostileLine& line) {
            line.receivePdu();
            line.sendAll({2, 0, 0xff, 0xff, 0xff, 0xff});  // of four gigabytes
            line.sendAll(Bytes(100000, 0));
        },
        [](HostileLine& line) {
            line.receivePdu();
            line.sendPdu(2, Bytes(10, 0));  // too short
        },
        [](HostileLine& line) {
            line.receivePdu();
            line.sendPdu(7, Bytes(4, 0));  // abort
        },
        [](HostileLine& line) {
            line.acceptAssociation();
            line.sendAll({4, 0, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 1, 3});
        },
        [](HostileLine& line) {
            line.acceptAssociation();
            line.receivePdu();
            line.sendPdu(4, {0, 0, 0, 200, 1, 3, 0});  // a fragment longer than its PDU
        },
        [](HostileLine& line) {
            line.acceptAssociation();
            line.receivePdu();
            line.sendPdu(4, {0, 0, 0, 0});
            line.sendPdu(9, {1, 2, 3});
        },
        [](HostileLine& line) {
            line.acceptAssociation();
            line.receivePdu();
            line.sendPdu(5, Bytes(4, 0));  // wants to end at once
            line.receivePdu();
        },
    };
    for (std::size_t i = 0; i < scripts.size(); ++i) {
        const HostilePeer peer(scripts[i]);
        Progress progress;
        const auto begin = Clock::now();
        const auto answers = hostileArchive(peer)->findStudies({}, progress);
        ASSERT_FALSE(answers) << i;
        EXPECT_EQ(answers.error().code, ErrorCode::archiveNotUsable) << i;
        EXPECT_FALSE(answers.error().hint.empty()) << i;
        EXPECT_LT(Clock::now() - begin, std::chrono::seconds(30)) << i;
    }
}

// PDUs of known and unknown kinds that have no place while an association is open (PS3.8 table 9-10).
TEST(DimseHostile, AMisplacedPduIsAnsweredOnce) {
    for (const std::uint8_t type : {1, 2, 3, 6, 8, 0xff}) {
        std::atomic<int> aborts{0};
        {
            const HostilePeer peer([&](HostileLine& line) {
                if (!line.acceptAssociation()) return;
                line.receiveCommandOf(CommandField::findRequest);
                line.sendPdu(type, Bytes(80, 0));
                while (const auto pdu = line.receivePdu())
                    if (pdu->first == 7) ++aborts;
            });
            Progress progress;
            const auto answers = hostileArchive(peer)->findStudies({}, progress);
            ASSERT_FALSE(answers) << int(type);
            EXPECT_EQ(answers.error().code, ErrorCode::archiveNotUsable) << int(type);
        }
        EXPECT_LE(aborts, 2) << int(type);
    }
}

TEST(DimseHostile, SilenceEndsInTime) {
    const HostilePeer deaf([](HostileLine& line) {
        while (line.receivePdu()) continue;
    });
    const HostilePeer mute([](HostileLine& line) {
        line.acceptAssociation();
        while (line.receivePdu()) continue;
    });
    for (const HostilePeer* peer : {&deaf, &mute}) {
        Progress progress;
        const auto begin = Clock::now();
        const auto answers = hostileArchive(*peer, 1)->findStudies({}, progress);
        ASSERT_FALSE(answers);
        EXPECT_EQ(answers.error().message.english(),
                  "The archive took the connection and then did not answer in time.");
        EXPECT_GE(Clock::now() - begin, std::chrono::milliseconds(900));
    }
}

TEST(DimseHostile, CancelEndsASilentPeer) {
    const HostilePeer deaf([](HostileLine& line) {
        while (line.receivePdu()) continue;
    });
    const HostilePeer mute([](HostileLine& line) {
        line.acceptAssociation();
        while (line.receivePdu()) continue;
    });
    for (const HostilePeer* peer : {&deaf, &mute}) {
        const CancelToken token;
        Progress progress({}, token);
        std::thread canceller([&] {
            comes([&] { return peer->connections() > 0; });
            std::this_thread::sleep_for(std::chrono::milliseconds(200));
            token.cancel();
        });
        const auto begin = Clock::now();
        const auto answers = hostileArchive(*peer, 3600)->findStudies({}, progress);
        EXPECT_LT(Clock::now() - begin, std::chrono::seconds(60));
        canceller.join();
        ASSERT_FALSE(answers);
        EXPECT_EQ(answers.error().code, ErrorCode::cancelled);
    }
}

Bytes instanceOf(const std::string& study, std::size_t pixels = 100) {
    return joined({explicitElement(0x00080016, "UI", kCt), explicitElement(0x00080018, "UI", "2.25.1.1.1"),
                   explicitElement(0x0020000d, "UI", study), explicitElement(0x0020000e, "UI", "2.25.1.1"),
                   explicitElement(0x7fe00010, "OW", std::string(pixels, 'p'))});
}

bool offer(HostileLine& line, const std::string& sopInstanceUid) {
    return line.sendCommand(line.contextOf(kCt), {.field = CommandField::storeRequest,
                                                  .messageId = std::uint16_t{7},
                                                  .sopClassUid = kCt,
                                                  .sopInstanceUid = sopInstanceUid,
                                                  .priority = std::uint16_t{0},
                                                  .hasDataset = true});
}

bool offer(HostileLine& line, const std::string& sopInstanceUid, const Bytes& dataset) {
    return offer(line, sopInstanceUid) && line.sendFragment(line.contextOf(kCt), false, true, dataset);
}

// A fetch from a peer that says nothing about what it has; `script` answers each C-GET.
struct HostileFetch {
    explicit HostileFetch(std::function<void(HostileLine&, const HostileLine::Received&)> script)
        : peer([script = std::move(script)](HostileLine& line) {
              if (!line.acceptAssociation()) return;
              while (const auto request = line.receiveCommand()) {
                  if (request->command.field == CommandField::findRequest)
                      lastAnswer(line, *request, CommandField::findResponse, 0xc000);
                  if (request->command.field == CommandField::getRequest) return script(line, *request);
              }
          }) {}
    Result<Fetched> run() {
        Progress progress;
        return hostileArchive(peer)->fetch({.studyInstanceUid = "2.25.1"}, receiver, progress);
    }
    HostilePeer peer;
    FolderReceiver receiver{100000};
};

TEST(DimseHostile, InstancesOfOtherStudiesAreRefused) {
    HostileFetch fetch([](HostileLine& line, const HostileLine::Received& request) {
        offer(line, "2.25.1.1.1", instanceOf("2.25.1"));
        const auto first = line.receiveCommand();
        EXPECT_TRUE(first && first->command.status == 0);
        offer(line, "2.25.666", instanceOf("2.25.6"));
        const auto second = line.receiveCommand();
        EXPECT_TRUE(second && second->command.status == 0xa900);
        lastAnswer(line, request, CommandField::getResponse);
        while (line.receiveCommand()) continue;
    });
    const auto result = fetch.run();
    ASSERT_TRUE(result) << told(result.error());
    EXPECT_EQ(result->kept, 1u);
    EXPECT_EQ(result->refused, 1u);
    EXPECT_EQ(fetch.receiver.filesInFolder(), 1u);
}

TEST(DimseHostile, NamesThatArePathsAreRefused) {
    const auto before = std::filesystem::current_path();
    HostileFetch fetch([](HostileLine& line, const HostileLine::Received& request) {
        for (const std::string name : {"../../../../tmp/evil", "/etc/passwd", "", "1.2\n3", "1.2.3 4"}) {
            offer(line, name, instanceOf("2.25.1"));
            const auto response = line.receiveCommand();
            EXPECT_TRUE(response && response->command.status == 0xa900) << name;
        }
        lastAnswer(line, request, CommandField::getResponse);
        while (line.receiveCommand()) continue;
    });
    const auto result = fetch.run();
    ASSERT_TRUE(result) << told(result.error());
    EXPECT_EQ(result->kept, 0u);
    EXPECT_EQ(result->refused, 5u);
    EXPECT_EQ(fetch.receiver.filesInFolder(), 0u);
}

TEST(DimseHostile, AnEndlessInstanceStopsAtTheLimit) {
    HostileFetch fetch([](HostileLine& line, const HostileLine::Received&) {
        offer(line, "2.25.1.1.1");
        while (line.sendFragment(line.contextOf(kCt), false, false, Bytes(16000, 'x'))) continue;
    });
    const auto result = fetch.run();
    // It is the same with every try.
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::archiveNotUsable);
    EXPECT_EQ(fetch.receiver.filesInFolder(), 0u);
    EXPECT_EQ(fetch.peer.connections(), 1 + 1 + 3);
}

TEST(DimseHostile, ABrokenConnectionIsMadeAgain) {
    std::atomic<int> tries{0};
    HostileFetch fetch([&](HostileLine& line, const HostileLine::Received& request) {
        const int attempt = tries++;
        const std::string uid = "2.25.1.1." + std::to_string(attempt + 1);
        if (attempt < 8) {  // each brings one more, and breaks in the middle of the next
            offer(line, uid, instanceOf("2.25.1"));
            line.receiveCommand();
            offer(line, "2.25.1.1.99");
            line.sendFragment(line.contextOf(kCt), false, false, Bytes(50, 'x'));
            return;
        }
        lastAnswer(line, request, CommandField::getResponse);
        while (line.receiveCommand()) continue;
    });
    const auto result = fetch.run();
    ASSERT_TRUE(result) << told(result.error());
    EXPECT_EQ(result->kept, 8u);
    EXPECT_EQ(fetch.receiver.filesInFolder(), 8u);
    EXPECT_EQ(fetch.receiver.drops(), 8u);
}

TEST(DimseHostile, AFloodOfPendingResponsesEnds) {
    HostileFetch fetch([](HostileLine& line, const HostileLine::Received& request) {
        while (lastAnswer(line, request, CommandField::getResponse, 0xff00)) continue;
    });
    const auto result = fetch.run();
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::archiveNotUsable);
}

TEST(DimseHostile, ResponsesToNothingAreErrors) {
    const std::vector<std::function<void(HostileLine&, const HostileLine::Received&)>> scripts{
        [](HostileLine& line, const HostileLine::Received& request) {
            line.sendCommand(request.context, {.field = CommandField::getResponse,
                                               .respondsTo = std::uint16_t{4711},
                                               .status = std::uint16_t{0}});
        },
        [](HostileLine& line, const HostileLine::Received& request) {
            line.sendCommand(request.context,
                             {.field = CommandField::echoRequest, .messageId = std::uint16_t{1}});
        },
        [](HostileLine& line, const HostileLine::Received&) {
            offer(line, "2.25.1.1.1");
            line.sendCommand(line.contextOf(kCt), {.field = CommandField::getResponse});
        },
        [](HostileLine& line, const HostileLine::Received&) {
            line.sendFragment(251, true, true,
                              bytesOf({.field = CommandField::storeRequest,
                                       .messageId = std::uint16_t{1},
                                       .sopClassUid = kCt,
                                       .sopInstanceUid = "2.25.1.1.1",
                                       .hasDataset = true}));
        },
    };
    for (std::size_t i = 0; i < scripts.size(); ++i) {
        HostileFetch fetch([&](HostileLine& line, const HostileLine::Received& request) {
            scripts[i](line, request);
            while (line.receivePdu()) continue;
        });
        const auto result = fetch.run();
        ASSERT_FALSE(result) << i;
        EXPECT_EQ(result.error().code, ErrorCode::archiveNotUsable) << i;
        EXPECT_EQ(fetch.receiver.filesInFolder(), 0u) << i;
    }
}

TEST(DimseHostile, ARefusedRetrievalIsNotWhole) {
    // The archive does not list what it has, sends one and then fails without counts.
    for (const std::uint16_t status : {std::uint16_t{0xa702}, std::uint16_t{0xc001}}) {
        HostileFetch fetch([&](HostileLine& line, const HostileLine::Received& request) {
            offer(line, "2.25.1.1.1", instanceOf("2.25.1"));
            line.receiveCommand();
            lastAnswer(line, request, CommandField::getResponse, status);
            while (line.receiveCommand()) continue;
        });
        const auto result = fetch.run();
        ASSERT_TRUE(result) << told(result.error());
        EXPECT_EQ(result->kept, 1u);
        EXPECT_EQ(result->promised, 1u);
        EXPECT_FALSE(result->isListWhole);
    }
}

}  // namespace

}  // namespace macula::net::test
