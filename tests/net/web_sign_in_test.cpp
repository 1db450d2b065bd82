// Who signs in how, where secrets go, and what an archive says to files that it is sent.
#include <gtest/gtest.h>

#include <fstream>

#include "dicom/support.h"
#include "dicom/synthetic.h"
#include "net/certificates.h"
#include "net/connect.h"
#include "net/scripted_server.h"
#include "net/web/web_address.h"
#include "net/web_receiver.h"

namespace macula::net::test {
namespace {

using dicom::test::TemporaryFolder;
using Request = ScriptedServer::Request;
using Peer = ScriptedServer::Peer;

constexpr const char* kDicomJson = "application/dicom+json";

Source sourceAt(const WebPeer& peer) {
    Source source;
    source.name = "web";
    source.peer = peer;
    return source;
}

std::string wordsOfSettings(const WebPeer& peer, const Secrets& secrets = {}) {
    const auto archive = archiveOf(sourceAt(peer), secrets);
    if (archive.ok()) return "no error";
    EXPECT_EQ(archive.error().code, ErrorCode::usage);
    EXPECT_FALSE(archive.error().hint.empty());
    return archive.error().message.english();
}

TEST(WebSettings, WhatCannotWorkIsToldBeforehand) {
    EXPECT_EQ(wordsOfSettings({.url = "https://pacs.example.org/dicom-web/"}), "no error");
    EXPECT_EQ(wordsOfSettings({.url = "http://pacs.example.org"}), "no error");
    for (const char* url :
         {"", "pacs", "ftp://pacs/", "file:///etc/passwd", "https://", "https://a b/",
          "https://pacs/\r\nX: y", "https://user:word@pacs/", "https://pacs/?x=y", "https://pacs/#x"})
        EXPECT_NE(wordsOfSettings({.url = url}), "no error") << url;
    EXPECT_NE(wordsOfSettings({.url = "https://pacs", .proxy = "gopher://x"}), "no error");
    EXPECT_NE(wordsOfSettings({.url = "https://pacs", .proxy = "http://u:word@proxy:1"}), "no error");
    EXPECT_NE(wordsOfSettings({.url = "https://pacs", .tls = {.authorities = "/missing.pem"}}), "no error");
    EXPECT_NE(wordsOfSettings({.url = "https://pacs", .tls = {.key = "/missing.pem"}}), "no error");
    EXPECT_NE(wordsOfSettings({.url = "https://pacs", .signIn = SignIn::bearer}, {.token = "a\nb"}),
              "no error");
    EXPECT_NE(wordsOfSettings({.url = "https://pacs", .signIn = SignIn::basic, .user = "a:b"}), "no error");
    EXPECT_NE(wordsOfSettings({.url = "https://pacs",
                               .signIn = SignIn::clientCredentials,
                               .tokenUrl = "http://tokens.example.org",
                               .clientId = "c"}),
              "no error");
}

TEST(WebSettings, SecretsGoInTheClearToThisMachineOnly) {
    const auto words = [](const char* url, SignIn signIn) {
        return wordsOfSettings({.url = url, .signIn = signIn, .user = "u"}, {.password = "p", .token = "t"});
    };
    for (const SignIn signIn : {SignIn::basic, SignIn::bearer}) {
        for (const char* url : {"http://127.0.0.1:80/x", "http://localhost", "http://[::1]:8042",
                                "http://127.9.9.9", "https://pacs"})
            EXPECT_EQ(words(url, signIn), "no error") << url;
        for (const char* url : {"http://pacs", "http://10.0.0.1", "http://127.0.0.1.example.org",
                                "http://localhost.org", "http://[::2]", "http://[::ffff:10.0.0.1]"})
            EXPECT_EQ(words(url, signIn), "A password or token would go over the network without encryption.")
                << url;
    }
    EXPECT_TRUE(mayRedirect("http://a/x", "https://A/y"));
    EXPECT_TRUE(mayRedirect("https://a/x?q", "https://a:443/y"));
    EXPECT_FALSE(mayRedirect("https://a/x", "http://a/x"));
    EXPECT_FALSE(mayRedirect("https://a/x", "https://a:8443/x"));
    EXPECT_FALSE(mayRedirect("https://a/x", "https://a.b/x"));
    EXPECT_FALSE(mayRedirect("https://a/x", "https://u@a/x"));
}

class WebSigning : public testing::Test {
  protected:
    // The headers of the first request of a search.
    std::string headersOf(WebPeer peer, const Secrets& secrets) {
        const ScriptedServer server([](const Request&, Peer& to) { to.answer(200, kDicomJson, "[]"); });
        peer.url = server.url();
        const auto archive = archiveOf(sourceAt(peer), secrets);
        EXPECT_TRUE((*archive)->findStudies({}, progress_).ok());
        return server.requests().at(0).headers;
    }

    TemporaryFolder folder_;
    Progress progress_;
};

TEST_F(WebSigning, HeadersSayWho) {
    EXPECT_EQ(headersOf({}, {.password = "unused"}).find("Authorization"), std::string::npos);
    EXPECT_NE(headersOf({.signIn = SignIn::basic, .user = "Aladdin"}, {.password = "open sesame"})
                  .find("Authorization: Basic QWxhZGRpbjpvcGVuIHNlc2FtZQ==\r\n"),
              std::string::npos);
    EXPECT_NE(
        headersOf({.signIn = SignIn::bearer}, {.token = "tok.en"}).find("Authorization: Bearer tok.en\r\n"),
        std::string::npos);
}

TEST_F(WebSigning, AProxyIsUsedButNotForThisMachine) {
    const ScriptedServer proxy([](const Request& request, Peer& peer) {
        if (request.method == "CONNECT") return peer.answer(403, "", "");
        peer.answer(200, kDicomJson, "[]");
    });
    const auto words = [&](const std::string& url) {
        const auto archive = archiveOf(sourceAt({.url = url, .proxy = proxy.url()}), {});
        const auto found = (*archive)->findStudies({}, progress_);
        return found.ok() ? std::string("no error") : found.error().message.english();
    };
    EXPECT_EQ(words("http://pacs.example.invalid/web"), "no error");
    ASSERT_EQ(proxy.requests().size(), 1u);
    EXPECT_TRUE(proxy.requests()[0].target.starts_with("http://pacs.example.invalid/web/studies?"));
    EXPECT_EQ(words("https://pacs.example.invalid/web"), "The proxy does not connect to the archive.");
    const std::size_t before = proxy.requests().size();
    const ScriptedServer server([](const Request&, Peer& peer) { peer.answer(200, kDicomJson, "[]"); });
    EXPECT_EQ(words(server.url()), "no error");
    EXPECT_EQ(proxy.requests().size(), before);
}

TEST_F(WebSigning, ATokenIsGotOnceAndRenewedOnce) {
    int tokens = 0;
    int life = 3600;
    const ScriptedServer service([&](const Request& request, Peer& peer) {
        EXPECT_EQ(request.method, "POST");
        EXPECT_EQ(request.body, "grant_type=client_credentials&scope=dicom%20read");
        EXPECT_TRUE(request.has("Authorization: Basic Y2w6cyUzQWU=")) << "cl:s%3Ae";
        peer.answer(200, "application/json",
                    "{\"access_token\":\"T" + std::to_string(++tokens) +
                        "\",\"expires_in\":" + std::to_string(life) + "}");
    });
    std::string accepted = "T1";
    int searches = 0;
    const ScriptedServer server([&](const Request& request, Peer& peer) {
        ++searches;
        const bool isRight = request.has("Authorization: Bearer " + accepted + "\r\n");
        peer.answer(isRight ? 200 : 401, kDicomJson, "[]");
    });
    WebPeer peer{.url = server.url(),
                 .signIn = SignIn::clientCredentials,
                 .tokenUrl = service.url() + "/token",
                 .clientId = "cl",
                 .scope = "dicom read"};
    const auto archive = archiveOf(sourceAt(peer), {.password = "s:e"});
    ASSERT_TRUE(archive.ok());
    EXPECT_TRUE((*archive)->findStudies({}, progress_).ok());
    EXPECT_TRUE((*archive)->findStudies({}, progress_).ok());
    EXPECT_EQ(tokens, 1);
    accepted = "T2";
    EXPECT_TRUE((*archive)->findStudies({}, progress_).ok());
    EXPECT_EQ(tokens, 2);
    EXPECT_EQ(searches, 4);
    accepted = "none";
    const auto found = (*archive)->findStudies({}, progress_);
    ASSERT_FALSE(found.ok());
    EXPECT_EQ(found.error().message, "The archive does not accept the sign-in (401).");
    EXPECT_EQ(tokens, 3) << "a token that is new is not asked for again";
}

TEST_F(WebSigning, ATokenServiceThatGivesNoneIsToldApart) {
    for (const std::string& answer :
         {std::string("{}"), std::string("{\"access_token\":7}"), std::string("<html>"),
          std::string("{\"access_token\":\"a\\r\\nb\"}"), std::string(60'000, '[')}) {
        const ScriptedServer service(
            [&](const Request&, Peer& peer) { peer.answer(200, "application/json", answer); });
        const ScriptedServer server([](const Request&, Peer& peer) { peer.answer(200, kDicomJson, "[]"); });
        WebPeer peer{.url = server.url(),
                     .signIn = SignIn::clientCredentials,
                     .tokenUrl = service.url(),
                     .clientId = "c"};
        const auto archive = archiveOf(sourceAt(peer), {});
        const auto found = (*archive)->findStudies({}, progress_);
        ASSERT_FALSE(found.ok());
        EXPECT_EQ(found.error().message, "The service that gives tokens for the archive did not give one.");
        EXPECT_TRUE(server.requests().empty());
        EXPECT_EQ((*archive)->test(progress_).back().name, "Sign-in");
    }
}

TEST_F(WebSigning, WhatAnArchiveRefusesIsNamed) {
    dicom::test::SyntheticSeries series;
    series.size = {4, 4, 3};
    const auto files = dicom::test::writeFiles(folder_.path(), series);
    std::vector<std::string> uids;
    for (const auto& file : files) uids.push_back(readFileMeta(file).value().sopInstanceUid);
    const auto item = [](const std::string& uid, const std::string& more) {
        return "{\"00081155\":{\"vr\":\"UI\",\"Value\":[\"" + uid + "\"]}" + more + "}";
    };
    const ScriptedServer server([&](const Request& request, Peer& peer) {
        EXPECT_TRUE(request.has("multipart/related; type=\"application/dicom\"; boundary="));
        std::ifstream first(files[0], std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(first), {}};
        EXPECT_NE(request.body.find("\r\n\r\n" + bytes + "\r\n--"), std::string::npos);
        peer.answer(202, kDicomJson,
                    "{\"00081199\":{\"vr\":\"SQ\",\"Value\":[" + item(uids[0], "") +
                        "]},\"00081198\":{\"vr\":\"SQ\",\"Value\":[" +
                        item(uids[1], ",\"00081197\":{\"vr\":\"US\",\"Value\":[42752]}") + "]}}");
    });
    const auto archive = archiveOf(sourceAt({.url = server.url()}), {});
    const auto sent = (*archive)->send(files, progress_);
    ASSERT_TRUE(sent.ok());
    EXPECT_EQ(sent->stored, 1u);
    ASSERT_EQ(sent->notSent.size(), 2u);
    EXPECT_EQ(sent->notSent[0].file, files[1]);
    EXPECT_EQ(sent->notSent[0].why, "The archive has no room left.");
    EXPECT_EQ(sent->notSent[1].file, files[2]);
    EXPECT_EQ(sent->notSent[1].why, "The archive did not store the object, and does not say why.");
    for (const NotSent& one : sent->notSent) EXPECT_FALSE(one.advice.empty());
}

TEST_F(WebSigning, FilesThatAreTooLargeTogetherGoOneByOne) {
    dicom::test::SyntheticSeries series;
    series.size = {4, 4, 4};
    const auto files = dicom::test::writeFiles(folder_.path(), series);
    const std::size_t most = std::filesystem::file_size(files[0]) * 3 / 2;
    const ScriptedServer server([&](const Request& request, Peer& peer) {
        peer.answer(request.body.size() > most ? 413 : 200, "", "");
    });
    const auto archive = archiveOf(sourceAt({.url = server.url()}), {});
    const auto sent = (*archive)->send(files, progress_);
    ASSERT_TRUE(sent.ok());
    EXPECT_EQ(sent->stored, 4u);
    EXPECT_EQ(server.requests().size(), 7u);
    // One that takes none at all.
    const ScriptedServer none([&](const Request&, Peer& peer) { peer.answer(413, "", ""); });
    const auto other = archiveOf(sourceAt({.url = none.url()}), {});
    const auto refused = (*other)->send(files, progress_);
    ASSERT_TRUE(refused.ok());
    EXPECT_EQ(refused->stored, 0u);
    EXPECT_EQ(refused->notSent.size(), 4u);
}

TEST_F(WebSigning, AHostThatDoesNotExistOrListenIsTold) {
    const auto words = [&](const std::string& url) {
        const auto archive = archiveOf(sourceAt({.url = url}), {});
        const auto found = (*archive)->findStudies({}, progress_);
        return found.ok() ? std::string("no error") : found.error().message.english();
    };
    EXPECT_EQ(words("http://no-such-host.invalid/"),
              "The name of the archive's host is not known in the network.");
    std::uint16_t port = 0;
    {
        const ScriptedServer gone([](const Request&, Peer&) {});
        port = gone.port();
    }
    EXPECT_EQ(words("http://127.0.0.1:" + std::to_string(port)),
              "The archive's host does not accept connections at this port.");
}

}  // namespace
}  // namespace macula::net::test
