// Servers that answer what no archive should: nothing crashes, hangs, fills the disk, or gets a secret.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "dicom/support.h"
#include "dicom/synthetic.h"
#include "net/connect.h"
#include "net/scripted_server.h"
#include "net/web_receiver.h"

namespace macula::net::test {
namespace {

using dicom::test::TemporaryFolder;
using Request = ScriptedServer::Request;
using Peer = ScriptedServer::Peer;

constexpr const char* kJson = "application/dicom+json";
constexpr const char* kParts = "multipart/related; type=\"application/dicom\"; boundary=B";

std::string bytesOfFile(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

// What archives do: a study 1.2 with one series 1.3, and its instances.
struct SmallStudy {
    explicit SmallStudy(const TemporaryFolder& folder, int count = 4) {
        dicom::test::SyntheticSeries series;
        series.studyUid = "1.2";
        series.seriesUid = "1.3";
        series.size = {4, 4, count};
        for (const auto& file : dicom::test::writeFiles(folder / "study", series)) {
            files.push_back(bytesOfFile(file));
            uids.push_back(readFileMeta(file).value().sopInstanceUid);
            if (!json.empty()) json += ",";
            json += R"({"0020000E":{"vr":"UI","Value":["1.3"]},"00080018":{"vr":"UI","Value":[")" +
                    uids.back() + "\"]}}";
        }
        json = "[" + json + "]";
    }

    // Answers searches as an archive does, empty where there is no more; false for anything else.
    bool answersSearch(const Request& request, Peer& peer) const {
        if (request.target.find("/instances?") == std::string::npos) return false;
        const bool isFirst = request.target.find("offset=0") != std::string::npos;
        peer.answer(200, kJson, isFirst ? json : "[]");
        return true;
    }
    // The file that a request for one instance wants; empty for the whole series.
    std::string fileOf(const Request& request) const {
        for (std::size_t i = 0; i < uids.size(); ++i)
            if (request.target.ends_with("/instances/" + uids[i])) return files[i];
        return {};
    }

    std::vector<std::string> files;
    std::vector<std::string> uids;
    std::string json;
};

std::unique_ptr<Archive> archiveAt(const std::string& url,
                                   std::chrono::seconds timeout = std::chrono::seconds(20)) {
    Source source;
    WebPeer peer;
    peer.url = url;
    source.peer = peer;
    source.answerTimeout = timeout;
    auto archive = archiveOf(source, {});
    EXPECT_TRUE(archive.ok());
    return *std::move(archive);
}

// Every error of an archive says what to do, and names nobody.
template <class T>
std::string wordsOf(const Result<T>& result) {
    if (result.ok()) return "no error";
    const Error& error = result.error();
    EXPECT_FALSE(error.hint.empty() && error.code != ErrorCode::cancelled);
    for (const std::string& text : {error.message.english(), error.hint.english(), error.where}) {
        EXPECT_EQ(text.find("1.2"), std::string::npos) << text;
        EXPECT_EQ(text.find("NAME"), std::string::npos) << text;
    }
    return error.message.english();
}

class WebHostile : public testing::Test {
  protected:
    std::string wordsOfSearch(const ScriptedServer::Answer& answer,
                              std::chrono::seconds timeout = std::chrono::seconds(20)) {
        const ScriptedServer server(answer);
        return wordsOf(archiveAt(server.url(), timeout)->findStudies({.patientName = "NAME"}, progress_));
    }
    std::string wordsOfStatus(int status) {
        return wordsOfSearch([=](const Request&, Peer& peer) { peer.answer(status, "text/html", "<html>"); });
    }

    TemporaryFolder folder_;
    Progress progress_;
};

TEST_F(WebHostile, EveryStatusHasWords) {
    EXPECT_EQ(wordsOfStatus(204), "no error");
    EXPECT_EQ(wordsOfStatus(400), "The archive does not understand the request (400).");
    EXPECT_EQ(wordsOfStatus(401), "The archive does not accept the sign-in (401).");
    EXPECT_EQ(wordsOfStatus(403), "The archive does not allow this to the user that is signed in (403).");
    EXPECT_EQ(wordsOfStatus(404), "The archive has nothing at this address (404).");
    EXPECT_EQ(wordsOfStatus(405), "The archive does not offer this service (405).");
    EXPECT_EQ(wordsOfStatus(418), "The archive answered with the unexpected status 418.");
    EXPECT_EQ(wordsOfStatus(429), "The archive has too much to do at the moment (429).");
    EXPECT_EQ(wordsOfStatus(500), "The archive has a fault of its own (500).");
    EXPECT_EQ(wordsOfStatus(503), "The archive has too much to do at the moment (503).");
    EXPECT_EQ(wordsOfStatus(200), "The archive's answer cannot be read.");
}

TEST_F(WebHostile, ABusyArchiveIsAskedOnceMore) {
    int asked = 0;
    const auto busy = [&](const Request&, Peer& peer) {
        if (++asked == 1) return peer.answer(503, "", "", "Retry-After: 1\r\n");
        peer.answer(200, kJson, "[]");
    };
    EXPECT_EQ(wordsOfSearch(busy), "no error");
    EXPECT_EQ(asked, 2);
    asked = 0;
    const auto always = [&](const Request&, Peer& peer) {
        ++asked;
        peer.answer(429, "", "", "Retry-After: 1\r\n");
    };
    EXPECT_EQ(wordsOfSearch(always), "The archive has too much to do at the moment (429).");
    EXPECT_EQ(asked, 2);
    asked = 0;
    const auto later = [&](const Request&, Peer& peer) {
        ++asked;
        peer.answer(503, "", "", "Retry-After: 86400\r\n");
    };
    EXPECT_EQ(wordsOfSearch(later), "The archive has too much to do at the moment (503).");
    EXPECT_EQ(asked, 1);
}

TEST_F(WebHostile, EndlessAnswersEnd) {
    const std::string much(1 << 20, ' ');
    EXPECT_EQ(wordsOfSearch([&](const Request&, Peer& peer) {
                  peer.send("HTTP/1.1 200 OK\r\nContent-Type: application/json\r\n\r\n");
                  while (peer.send(much)) {
                  }
              }),
              "The archive's answer is larger than any should be.");
    EXPECT_EQ(wordsOfSearch([&](const Request&, Peer& peer) {
                  peer.send("HTTP/1.1 500 Error\r\n\r\n");
                  while (peer.send(much)) {
                  }
              }),
              "The archive has a fault of its own (500).");
    EXPECT_EQ(wordsOfSearch([&](const Request&, Peer& peer) {
                  peer.send("HTTP/1.1 200 OK\r\n");
                  while (peer.send("X-More: " + std::string(1000, 'x') + "\r\n")) {
                  }
              }),
              "The archive's answer is larger than any should be.");
    EXPECT_EQ(
        wordsOfSearch([&](const Request&, Peer& peer) {
            while (peer.send("HTTP/1.1 102 Processing\r\nX-More: " + std::string(1000, 'x') + "\r\n\r\n")) {
            }
        }),
        "The archive's answer is larger than any should be.");
}

TEST_F(WebHostile, WhatIsNotHttpIsAnError) {
    for (const std::string& bytes :
         {std::string("SSH-2.0-OpenSSH\r\n"), std::string("\0\1\2\3", 4), std::string("HTTP/1.1 abc\r\n\r\n"),
          std::string("HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\nzz\r\nx\r\n0\r\n\r\n"),
          std::string("HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\nffffffffffffffffffff\r\nx"),
          std::string("HTTP/1.1 200 OK\r\nContent-Length: -1\r\n\r\n[]"),
          std::string("HTTP/1.1 200 OK\r\nContent-Length: 100\r\n\r\n[]"), std::string()}) {
        const std::string words = wordsOfSearch([&](const Request&, Peer& peer) { peer.send(bytes); });
        EXPECT_NE(words, "no error") << bytes;
    }
}

TEST_F(WebHostile, PackedAnswersAreRefused) {
    // What they would unpack to does not matter: they are not unpacked.
    EXPECT_EQ(wordsOfSearch([&](const Request& request, Peer& peer) {
                  EXPECT_TRUE(request.has("Accept-Encoding: identity"));
                  peer.answer(200, kJson, "\x1f\x8b bomb", "Content-Encoding: gzip\r\n");
              }),
              "The archive compresses its answers, although it was not asked to.");
}

TEST_F(WebHostile, NestedAnswersAreRefused) {
    EXPECT_EQ(wordsOfSearch([&](const Request&, Peer& peer) {
                  peer.answer(200, kJson, std::string(100'000, '[') + std::string(100'000, ']'));
              }),
              "The archive's answer cannot be read.");
}

TEST_F(WebHostile, RedirectionsLeadNowhereElse) {
    const ScriptedServer other([](const Request&, Peer& peer) { peer.answer(200, kJson, "[]"); });
    const std::string port = std::to_string(other.port());
    for (const std::string& place :
         {std::string("file:///etc/passwd"), "http://127.0.0.1:" + port + "/studies",
          "http://localhost:" + port, std::string("ftp://127.0.0.1/x"),
          std::string("http://user:word@127.0.0.1/"), std::string("//[::1]/")}) {
        for (const int status : {301, 302, 303, 307, 308}) {
            EXPECT_EQ(wordsOfSearch([&](const Request&, Peer& peer) {
                          peer.answer(status, "", "", "Location: " + place + "\r\n");
                      }),
                      "The archive refers to another host, which gets no requests.")
                << place;
        }
    }
    EXPECT_TRUE(other.requests().empty());
    int asked = 0;
    EXPECT_EQ(wordsOfSearch([&](const Request& request, Peer& peer) {
                  ++asked;
                  if (request.target != "/there") return peer.answer(307, "", "", "Location: /there\r\n");
                  peer.answer(200, kJson, "[]");
              }),
              "no error");
    EXPECT_EQ(asked, 2);
    asked = 0;
    EXPECT_NE(wordsOfSearch([&](const Request&, Peer& peer) {
                  peer.answer(307, "", "", "Location: /again" + std::to_string(++asked) + "\r\n");
              }),
              "no error");
    EXPECT_EQ(asked, 6);
}

TEST_F(WebHostile, SilenceEnds) {
    EXPECT_EQ(
        wordsOfSearch([](const Request&, Peer& peer) { peer.waitUntilGone(); }, std::chrono::seconds(1)),
        "The archive stopped answering.");
    EXPECT_EQ(wordsOfSearch(
                  [](const Request&, Peer& peer) {
                      peer.send("HTTP/1.1 200 OK\r\nContent-Length: 10\r\n\r\n[");
                      peer.waitUntilGone();
                  },
                  std::chrono::seconds(1)),
              "The archive stopped answering.");
}

TEST_F(WebHostile, ACancelEndsWhatWouldNot) {
    const CancelToken token;
    Progress progress({}, token);
    const ScriptedServer server([&](const Request&, Peer& peer) {
        peer.send("HTTP/1.1 200 OK\r\n\r\n");
        token.cancel();
        while (peer.send(" ")) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    });
    const auto found = archiveAt(server.url())->findStudies({}, progress);
    ASSERT_FALSE(found.ok());
    EXPECT_EQ(found.error().code, ErrorCode::cancelled);
}

TEST_F(WebHostile, PagesFollowEachOtherAndEnd) {
    // An archive that never has enough: each page has other studies, 100 however many are asked for.
    int next = 0;
    const ScriptedServer endless([&](const Request&, Peer& peer) {
        std::string page = "[";
        for (int i = 0; i < 100; ++i)
            page += std::string(i > 0 ? "," : "") + "{\"0020000D\":\"1.2." + std::to_string(++next) + "\"}";
        peer.answer(200, kJson, page + "]");
    });
    const auto some = archiveAt(endless.url())->findStudies({.mostAnswers = 250}, progress_);
    ASSERT_TRUE(some.ok());
    EXPECT_EQ(some->studies.size(), 250u);
    EXPECT_TRUE(some->isCutShort);
    ASSERT_EQ(endless.requests().size(), 3u);
    EXPECT_NE(endless.requests()[0].target.find("limit=251&offset=0"), std::string::npos);
    EXPECT_NE(endless.requests()[1].target.find("limit=151&offset=100"), std::string::npos);
    // One that gives the same page for ever.
    const ScriptedServer same([&](const Request&, Peer& peer) {
        std::string page = "[";
        for (int i = 0; i < 150; ++i)
            page += std::string(i > 0 ? "," : "") + "{\"0020000D\":\"1.2." + std::to_string(i) + "\"}";
        peer.answer(200, kJson, page + "]");
    });
    const auto all = archiveAt(same.url())->findStudies({}, progress_);
    ASSERT_TRUE(all.ok());
    EXPECT_EQ(all->studies.size(), 150u);
    EXPECT_FALSE(all->isCutShort);
    EXPECT_EQ(same.requests().size(), 2u);
    // One that refuses large pages.
    const ScriptedServer small([&](const Request& request, Peer& peer) {
        if (request.target.find("limit=200") == std::string::npos) return peer.answer(400, "", "");
        peer.answer(200, kJson, "[{\"0020000D\":\"1.2\"}]");
    });
    const auto one = archiveAt(small.url())->findStudies({}, progress_);
    ASSERT_TRUE(one.ok());
    EXPECT_EQ(one->studies.size(), 1u);
}

TEST_F(WebHostile, AFetchThatBreaksGoesOn) {
    const SmallStudy study(folder_);
    int series = 0;
    const ScriptedServer server([&](const Request& request, Peer& peer) {
        if (study.answersSearch(request, peer)) return;
        const std::string one = study.fileOf(request);
        if (!one.empty()) return peer.answer(200, kParts, multipartOf({one}, "B"));
        ++series;
        // Half of it, and half of an instance.
        const std::string body = multipartOf(study.files, "B");
        peer.send("HTTP/1.1 200 OK\r\nContent-Type: " + std::string(kParts) + "\r\nContent-Length: " +
                  std::to_string(body.size()) + "\r\n\r\n" + body.substr(0, body.size() / 2 + 100));
    });
    WebReceiver receiver(folder_ / "fetched");
    const auto fetched = archiveAt(server.url())->fetch({.studyInstanceUid = "1.2"}, receiver, progress_);
    ASSERT_TRUE(fetched.ok()) << wordsOf(fetched);
    EXPECT_EQ(series, 1) << "then only what is missing is asked for";
    EXPECT_EQ(fetched->kept, 4u);
    EXPECT_TRUE(fetched->never.empty());
    EXPECT_EQ(receiver.dropped, 1);
    for (std::size_t i = 0; i < study.files.size(); ++i)
        EXPECT_EQ(bytesOfFile(receiver.kept.at(study.uids[i])), study.files[i]);
}

TEST_F(WebHostile, AFetchThatAlwaysBreaksEnds) {
    const SmallStudy study(folder_);
    int tries = 0;
    const ScriptedServer server([&](const Request& request, Peer& peer) {
        if (study.answersSearch(request, peer)) return;
        ++tries;
        peer.send("HTTP/1.1 200 OK\r\nContent-Type: " + std::string(kParts) + "\r\n\r\n--B\r\n\r\n" +
                  study.files[0].substr(0, 200));
    });
    WebReceiver receiver(folder_ / "fetched");
    const auto fetched = archiveAt(server.url())->fetch({.studyInstanceUid = "1.2"}, receiver, progress_);
    EXPECT_EQ(tries, 4) << "once, and three times more";
    ASSERT_FALSE(fetched.ok());
    EXPECT_EQ(fetched.error().code, ErrorCode::archiveNotUsable);
    wordsOf(fetched);
    EXPECT_EQ(receiver.bytesOnDisk(), 0u);
}

TEST_F(WebHostile, WhatIsPromisedAndNotSentIsNamed) {
    const SmallStudy study(folder_);
    const ScriptedServer server([&](const Request& request, Peer& peer) {
        if (study.answersSearch(request, peer)) return;
        const std::string one = study.fileOf(request);
        if (!one.empty()) return peer.answer(404, "", "");
        peer.answer(200, kParts, multipartOf({study.files[0], study.files[2]}, "B"));
    });
    WebReceiver receiver(folder_ / "fetched");
    const auto fetched = archiveAt(server.url())->fetch({.studyInstanceUid = "1.2"}, receiver, progress_);
    ASSERT_TRUE(fetched.ok()) << wordsOf(fetched);
    EXPECT_EQ(fetched->promised, 4u);
    EXPECT_EQ(fetched->kept, 2u);
    ASSERT_EQ(fetched->never.size(), 2u);
    EXPECT_EQ(fetched->never[0].sopInstanceUid, study.uids[1]);
    EXPECT_EQ(fetched->never[1].sopInstanceUid, study.uids[3]);
}

TEST_F(WebHostile, OtherBodiesThanInstancesAreErrors) {
    const SmallStudy study(folder_);
    for (const std::string& type :
         {std::string("text/html"), std::string(""), std::string("multipart/related"),
          std::string("multipart/related; boundary=other")}) {
        const ScriptedServer server([&](const Request& request, Peer& peer) {
            if (study.answersSearch(request, peer)) return;
            peer.answer(200, type, multipartOf(study.files, "B"));
        });
        WebReceiver receiver(folder_ / "fetched");
        const auto fetched = archiveAt(server.url())->fetch({.studyInstanceUid = "1.2"}, receiver, progress_);
        const bool isEmpty = fetched.ok() && fetched->kept == 0 && fetched->never.size() == 4;
        EXPECT_TRUE(isEmpty || !fetched.ok()) << type;
        EXPECT_EQ(receiver.bytesOnDisk(), 0u) << type;
    }
}

TEST_F(WebHostile, TheDiskIsNotFilled) {
    const SmallStudy study(folder_);
    constexpr std::uintmax_t kMost = 1 << 20;
    const std::string much(1 << 16, 'x');
    const ScriptedServer server([&](const Request& request, Peer& peer) {
        if (study.answersSearch(request, peer)) return;
        peer.send("HTTP/1.1 200 OK\r\nContent-Type: " + std::string(kParts) + "\r\n\r\n--B\r\n\r\n" +
                  study.files[0]);
        while (peer.send(much)) {
        }
    });
    WebReceiver receiver(folder_ / "fetched", kMost);
    const auto fetched = archiveAt(server.url())->fetch({.studyInstanceUid = "1.2"}, receiver, progress_);
    if (fetched.ok()) {
        EXPECT_GE(fetched->refused, 1u);
        EXPECT_EQ(fetched->never.size(), 3u);
    }
    EXPECT_EQ(receiver.bytesOnDisk(), 0u);
    EXPECT_EQ(receiver.dropped, receiver.placed);
}

TEST_F(WebHostile, MoreInstancesThanWereAskedForEnd) {
    const SmallStudy study(folder_);
    const ScriptedServer server([&](const Request& request, Peer& peer) {
        if (study.answersSearch(request, peer)) return;
        peer.send("HTTP/1.1 200 OK\r\nContent-Type: " + std::string(kParts) + "\r\n\r\n");
        while (peer.send("--B\r\n\r\n" + study.files[0] + "\r\n")) {
        }
    });
    WebReceiver receiver(folder_ / "fetched");
    const auto fetched = archiveAt(server.url())->fetch({.studyInstanceUid = "1.2"}, receiver, progress_);
    ASSERT_TRUE(fetched.ok()) << wordsOf(fetched);
    EXPECT_EQ(fetched->kept, 1u);
    EXPECT_EQ(fetched->never.size(), 3u);
    EXPECT_LT(receiver.taken, 100);
}

TEST_F(WebHostile, AnErrorOfTheReceiverEndsTheFetch) {
    const SmallStudy study(folder_);
    const ScriptedServer server([&](const Request& request, Peer& peer) {
        if (study.answersSearch(request, peer)) return;
        peer.answer(200, kParts, multipartOf(study.files, "B"));
    });
    WebReceiver receiver(folder_ / "fetched");
    receiver.errorOfPlace =
        Error{ErrorCode::outputNotWritable, Text("The quota is used up."), {}, Text("Ask.")};
    const auto fetched = archiveAt(server.url())->fetch({.studyInstanceUid = "1.2"}, receiver, progress_);
    ASSERT_FALSE(fetched.ok());
    EXPECT_EQ(fetched.error().message, "The quota is used up.");
    EXPECT_EQ(server.requests().size(), 2u);
}

TEST_F(WebHostile, AStudyThatIsGoneIsAnError) {
    const ScriptedServer server([&](const Request&, Peer& peer) { peer.answer(200, kJson, "[]"); });
    WebReceiver receiver(folder_ / "fetched");
    const auto fetched = archiveAt(server.url())->fetch({.studyInstanceUid = "1.2"}, receiver, progress_);
    EXPECT_EQ(wordsOf(fetched), "The archive has no images of this study.");
}

TEST_F(WebHostile, AListThatIsNotWholeIsSaid) {
    const SmallStudy study(folder_);
    const std::string withoutUid = study.json.substr(0, study.json.size() - 1) + ",{}]";
    for (const std::string& json : {study.json, withoutUid}) {
        const ScriptedServer server([&](const Request& request, Peer& peer) {
            if (request.target.find("/instances?") != std::string::npos)
                return peer.answer(200, kJson,
                                   request.target.find("offset=0") != std::string::npos ? json : "[]");
            peer.answer(200, kParts, multipartOf(study.files, "B"));
        });
        WebReceiver receiver(folder_ / "fetched");
        const auto fetched = archiveAt(server.url())->fetch({.studyInstanceUid = "1.2"}, receiver, progress_);
        ASSERT_TRUE(fetched.ok()) << wordsOf(fetched);
        EXPECT_EQ(fetched->kept + fetched->hadAlready, 4u);
        EXPECT_EQ(fetched->isListWhole, json == study.json);
    }
}

TEST_F(WebHostile, CountsOfSeriesAreNoList) {
    const SmallStudy study(folder_);
    const ScriptedServer server([&](const Request& request, Peer& peer) {
        if (request.target.find("/instances?") != std::string::npos) return peer.answer(501, "", "");
        if (request.target.find("/series?") != std::string::npos)
            return peer.answer(200, kJson, R"([{"0020000E":"1.3","00201209":2}])");
        peer.answer(200, kParts, multipartOf(study.files, "B"));
    });
    WebReceiver receiver(folder_ / "fetched");
    const auto fetched = archiveAt(server.url())->fetch({.studyInstanceUid = "1.2"}, receiver, progress_);
    ASSERT_TRUE(fetched.ok()) << wordsOf(fetched);
    EXPECT_EQ(fetched->kept, 4u);
    EXPECT_EQ(fetched->promised, 4u);
    EXPECT_FALSE(fetched->isListWhole);
}

TEST_F(WebHostile, WhatWasThereAndComesAgainCountsOnce) {
    const SmallStudy study(folder_);
    const ScriptedServer server([&](const Request& request, Peer& peer) {
        if (study.answersSearch(request, peer)) return;
        peer.answer(200, kParts, multipartOf(study.files, "B"));
    });
    WebReceiver receiver(folder_ / "fetched");
    receiver.kept[study.uids[0]] = folder_ / "before";
    const auto fetched =
        archiveAt(server.url())
            ->fetch({.studyInstanceUid = "1.2", .sopInstancesHad = {study.uids[0]}}, receiver, progress_);
    ASSERT_TRUE(fetched.ok()) << wordsOf(fetched);
    EXPECT_EQ(fetched->hadAlready, 1u);
}

}  // namespace
}  // namespace macula::net::test
