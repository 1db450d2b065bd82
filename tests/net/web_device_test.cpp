// Signing in by a browser (RFC 8628), with a service that answers as the standard says, and as it does not.
#include <gtest/gtest.h>

#include <deque>
#include <filesystem>

#include "dicom/support.h"
#include "net/connect.h"
#include "net/scripted_server.h"
#include "net/web/device_sign_in.h"

namespace macula::net::test {
namespace {

using Request = ScriptedServer::Request;
using Peer = ScriptedServer::Peer;

constexpr const char* kJson = "application/json";
const std::string kCodes =
    R"({"device_code":"D","user_code":"WDJB-MJHT","verification_uri":"https://sign.example.org/device",)"
    R"("verification_uri_complete":"https://sign.example.org/device?user_code=WDJB-MJHT","interval":0.1})";

class DeviceSignInTest : public testing::Test {
  protected:
    Source sourceAt(const std::string& archive, const std::string& service) {
        Source source;
        source.name = "Cloud";
        WebPeer peer;
        peer.url = archive;
        peer.signIn = SignIn::device;
        peer.deviceUrl = service + "/device";
        peer.tokenUrl = service + "/token";
        peer.clientId = "macula";
        peer.scope = "openid offline_access";
        source.peer = peer;
        return source;
    }
    // The answers of the token service, one after the other; the last one stays.
    std::deque<std::pair<int, std::string>> answers_;
    std::string codes_ = kCodes;
    std::vector<std::string> forms_;
    ScriptedServer service_{[this](const Request& request, Peer& peer) {
        forms_.push_back(request.body);
        if (request.target == "/device") return peer.answer(200, kJson, codes_);
        const auto answer = answers_.front();
        if (answers_.size() > 1) answers_.pop_front();
        peer.answer(answer.first, kJson, answer.second);
    }};
    Progress progress_;
    std::vector<DeviceCode> shown_;

    Result<Secrets> signIn(const Source& source) {
        return signInByDevice(
            source, {}, [this](const DeviceCode& code) { shown_.push_back(code); }, progress_);
    }
    std::string words() {
        const auto secrets = signIn(sourceAt("http://127.0.0.1:1/web", service_.url()));
        if (secrets) return "signed in";
        EXPECT_FALSE(secrets.error().hint.empty());
        return secrets.error().message.english();
    }
};

TEST_F(DeviceSignInTest, WaitsForThePersonAndKeepsWhatCame) {
    answers_ = {{400, R"({"error":"authorization_pending"})"},
                {400, R"({"error":"authorization_pending"})"},
                {200, R"({"access_token":"A1","refresh_token":"R1","expires_in":60})"}};
    const auto secrets = signIn(sourceAt("http://127.0.0.1:1/web", service_.url()));
    ASSERT_TRUE(secrets) << secrets.error().message;
    EXPECT_EQ(secrets->token, "A1");
    EXPECT_EQ(secrets->refreshToken, "R1");
    ASSERT_EQ(shown_.size(), 1u);
    EXPECT_EQ(shown_[0].userCode, "WDJB-MJHT");
    EXPECT_EQ(shown_[0].address, "https://sign.example.org/device");
    ASSERT_EQ(forms_.size(), 4u);
    EXPECT_EQ(forms_[0], "client_id=macula&scope=openid%20offline_access");
    EXPECT_EQ(
        forms_[1],
        "grant_type=urn%3Aietf%3Aparams%3Aoauth%3Agrant-type%3Adevice_code&device_code=D&client_id=macula");
}

TEST_F(DeviceSignInTest, SaysWhyNobodyIsSignedIn) {
    answers_ = {{400, R"({"error":"access_denied"})"}};
    EXPECT_EQ(words(), "The sign-in was declined in the browser.");
    answers_ = {{400, R"({"error":"expired_token"})"}};
    EXPECT_EQ(words(), "Nobody signed in before the code ran out.");
    answers_ = {{400, R"({"error":"something"})"}};
    EXPECT_EQ(words(), "The service that gives tokens for the archive did not give one.");
    answers_ = {{200, "<html>"}};
    EXPECT_EQ(words(), "The service that gives tokens for the archive did not give one.");
    answers_ = {{400, R"({"error":"authorization_pending"})"}};
    codes_.insert(1, R"("expires_in":1,)");
    EXPECT_EQ(words(), "Nobody signed in before the code ran out.");
}

TEST_F(DeviceSignInTest, ShowsNoAddressThatABrowserShouldNotOpen) {
    answers_ = {{200, R"({"access_token":"A1"})"}};
    for (const char* address : {"http://sign.example.org/", "file:///etc/passwd", "javascript:alert(1)", "",
                                "https://a b/", "https://user:word@a/"}) {
        codes_ = std::string(R"({"device_code":"D","user_code":"U","interval":0.1,"verification_uri":")") +
                 address + R"("})";
        EXPECT_EQ(words(), "The service that signs people in gave no code.") << address;
    }
    codes_ = R"({"device_code":"D","user_code":"U\u001b[2J","verification_uri":"https://a.example.org/"})";
    EXPECT_EQ(words(), "The service that signs people in gave no code.");
    codes_ =
        R"({"device_code":"D","user_code":"U","interval":0.1,"verification_uri":"https://a.example.org/",)"
        R"("verification_uri_complete":"file:///x"})";
    EXPECT_EQ(words(), "signed in");
    EXPECT_TRUE(shown_.back().wholeAddress.empty());
}

TEST_F(DeviceSignInTest, EndsWhenItIsCancelled) {
    answers_ = {{400, R"({"error":"authorization_pending"})"}};
    const auto secrets = signInByDevice(
        sourceAt("http://127.0.0.1:1/web", service_.url()), {},
        [this](const DeviceCode&) { progress_.token().cancel(); }, progress_);
    ASSERT_FALSE(secrets);
    EXPECT_EQ(secrets.error().code, ErrorCode::cancelled);
}

TEST_F(DeviceSignInTest, AnArchiveThatNobodySignsInAtSoIsUsage) {
    Source source;
    source.name = "Hospital";
    source.peer = DimsePeer{.host = "127.0.0.1", .port = 104, .calledAe = "A"};
    EXPECT_EQ(signIn(source).error().code, ErrorCode::usage);
}

TEST_F(DeviceSignInTest, ATokenThatEndedIsRenewedAndTheNewOneKept) {
    const dicom::test::TemporaryFolder folder;
    std::string accepted = "A1";
    const ScriptedServer archive([&](const Request& request, Peer& peer) {
        const bool isRight = request.has("Authorization: Bearer " + accepted + "\r\n");
        peer.answer(isRight ? 200 : 401, "application/dicom+json", "[]");
    });
    const Source source = sourceAt(archive.url(), service_.url());
    auto list = SourceList::read({.managed = {}, .own = folder / "own", .secrets = folder / "secrets"});
    ASSERT_TRUE(list);
    ASSERT_TRUE(list->put(source));
    ASSERT_TRUE(list->keep(source, {.token = "A1", .refreshToken = "R1"}));
    const auto finds = [&] {
        const auto opened = archiveOf(*list, source);
        EXPECT_TRUE(opened);
        return (*opened)->findStudies({}, progress_);
    };
    EXPECT_TRUE(finds());
    EXPECT_TRUE(forms_.empty()) << "the first token still serves";
    accepted = "A2";
    answers_ = {{200, R"({"access_token":"A2","refresh_token":"R2"})"}};
    EXPECT_TRUE(finds());
    ASSERT_EQ(forms_.size(), 1u);
    EXPECT_EQ(forms_[0], "grant_type=refresh_token&refresh_token=R1&client_id=macula");
    EXPECT_EQ(list->secretsOf(source)->refreshToken, "R2") << "R1 may be of no more use";
    EXPECT_EQ(list->secretsOf(source)->token, "A2");
    accepted = "A3";
    answers_ = {{400, R"({"error":"invalid_grant"})"}};
    const auto over = finds();
    ASSERT_FALSE(over);
    EXPECT_EQ(over.error().message, "The sign-in at the archive is over.");
    EXPECT_EQ(over.error().code, ErrorCode::archiveNotUsable);
}

// Two windows have the same refresh token: it is used once, and both go on.
TEST_F(DeviceSignInTest, ATokenThatAnotherHasRenewedIsTaken) {
    const dicom::test::TemporaryFolder folder;
    const ScriptedServer archive([&](const Request& request, Peer& peer) {
        const bool isRight = request.has("Authorization: Bearer A2\r\n");
        peer.answer(isRight ? 200 : 401, "application/dicom+json", "[]");
    });
    const Source source = sourceAt(archive.url(), service_.url());
    auto list = SourceList::read({.managed = {}, .own = folder / "own", .secrets = folder / "secrets"});
    ASSERT_TRUE(list);
    ASSERT_TRUE(list->put(source));
    ASSERT_TRUE(list->keep(source, {.token = "A1", .refreshToken = "R1"}));
    const auto one = archiveOf(*list, source);
    const auto other = archiveOf(*list, source);
    ASSERT_TRUE(one);
    ASSERT_TRUE(other);
    answers_ = {{200, R"({"access_token":"A2","refresh_token":"R2"})"},
                {400, R"({"error":"invalid_grant"})"}};
    EXPECT_TRUE((*one)->findStudies({}, progress_));
    EXPECT_TRUE((*other)->findStudies({}, progress_));
    EXPECT_EQ(forms_.size(), 1u);
}

TEST_F(DeviceSignInTest, AServiceThatFailsForAMomentEndsNothing) {
    answers_ = {{400, R"({"error":"authorization_pending"})"},
                {503, "{}"},
                {500, "<html>"},
                {200, R"({"access_token":"A1","refresh_token":"R1","expires_in":60})"}};
    EXPECT_EQ(words(), "signed in");
    answers_ = {{503, "{}"}};
    forms_.clear();
    EXPECT_NE(words(), "signed in");
    EXPECT_EQ(forms_.size(), 6u) << "it is tried some times, and then given up";
}

}  // namespace
}  // namespace macula::net::test
