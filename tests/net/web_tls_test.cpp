// TLS with archives of the web: whom this computer trusts, and how it shows who it is.
#include <gtest/gtest.h>

#include "dicom/support.h"
#include "net/certificates.h"
#include "net/connect.h"
#include "net/programs.h"
#include "net/scripted_server.h"
#include "net/tls_front.h"

namespace macula::net::test {
namespace {

using dicom::test::TemporaryFolder;

class WebTls : public testing::Test {
  protected:
    std::filesystem::path folder(const std::string& name) const {
        std::filesystem::create_directory(folder_ / name);
        return folder_ / name;
    }

    // What a search says, and the step at which a test of the archive ends.
    struct Said {
        std::string words = "no error";
        std::string lastStep;
        bool isUsage = false;
    };
    static Said said(const TlsFront& front, const Tls& tls, const Secrets& secrets = {}) {
        return said(WebPeer{.url = "https://127.0.0.1:" + std::to_string(front.port()), .tls = tls}, secrets);
    }
    static Said said(const WebPeer& peer, const Secrets& secrets = {}) {
        Source source;
        source.peer = peer;
        Said result;
        auto archive = archiveOf(source, secrets);
        if (!archive) {
            result.words = archive.error().message.english();
            result.isUsage = archive.error().code == ErrorCode::usage;
            return result;
        }
        Progress progress;
        if (const auto found = (*archive)->findStudies({}, progress); !found.ok()) {
            result.words = found.error().message.english();
            EXPECT_EQ(found.error().code, ErrorCode::archiveNotUsable);
            EXPECT_FALSE(found.error().hint.empty());
        }
        const auto steps = (*archive)->test(progress);
        result.lastStep = steps.back().name.english();
        EXPECT_EQ(steps.back().passed, result.words == "no error");
        return result;
    }

    TemporaryFolder folder_;
    // An archive that is empty.
    ScriptedServer server_{[](const ScriptedServer::Request&, ScriptedServer::Peer& peer) {
        peer.answer(200, "application/dicom+json", "[]");
    }};
};

TEST_F(WebTls, ACertificateMustBeTrustedAndOfThisHostAndTime) {
    const Authority authority(folder("tls"));
    const auto with = [&](const Certificate& shown) { return TlsFront(shown, server_.port()); };
    {
        const Said expired =
            said(with(authority.sign("expired", {.isExpired = true})), {.authorities = authority.file()});
        EXPECT_EQ(expired.words, "The archive's certificate is not valid at this time.");
        EXPECT_EQ(expired.lastStep, "Encryption");
    }
    {
        const Said other = said(with(authority.sign("other", {.host = "pacs.example.org"})),
                                {.authorities = authority.file()});
        EXPECT_EQ(other.words, "The archive's certificate is for another host.");
        EXPECT_EQ(other.lastStep, "Encryption");
    }
    const Certificate right = authority.sign("right");
    const TlsFront front = with(right);
    EXPECT_EQ(said(front, {.authorities = authority.file()}).words, "no error");
    EXPECT_EQ(said(front, {}).words,
              "The archive's certificate is signed by nobody whom this computer trusts.");
    EXPECT_EQ(said(front, {.authorities = right.key}).words,
              "The file or folder of trusted authorities cannot be read.");
    EXPECT_TRUE(said(front, {.authorities = folder_ / "missing"}).isUsage);
    // A folder of hashed certificates.
    std::filesystem::create_directory(folder_ / "hashed");
    std::filesystem::copy_file(authority.file(), folder_ / "hashed" / "one.pem");
    const Ran hashed =
        ran({programNamed("openssl"), "rehash", (folder_ / "hashed").string()}, folder_.path());
    ASSERT_EQ(hashed.exitCode, 0) << hashed.output;
    EXPECT_EQ(said(front, {.authorities = folder_ / "hashed"}).words, "no error");
}

TEST_F(WebTls, AnArchiveWithoutItIsToldApart) {
    // A server that does not understand what it gets says so, in the clear.
    const ScriptedServer plain([](const ScriptedServer::Request&, ScriptedServer::Peer&) {},
                               "HTTP/1.1 400 Bad Request\r\n\r\n");
    const Said encrypted = said(WebPeer{.url = "https://127.0.0.1:" + std::to_string(plain.port())});
    EXPECT_EQ(encrypted.words, "The archive does not encrypt at this port.");
    EXPECT_EQ(encrypted.lastStep, "Encryption");
    // The other way round, it closes.
    const TlsFront front(Authority(folder("tls")).sign("server"), server_.port());
    EXPECT_NE(said(WebPeer{.url = "http://127.0.0.1:" + std::to_string(front.port())}).words, "no error");
}

TEST_F(WebTls, ACertificateOfOursIsShown) {
    const Authority authority(folder("tls"));
    const Authority other(folder("other"));
    const TlsFront front(authority.sign("server"), server_.port(), authority.file());
    const Certificate own = authority.sign("own", {.keyPassphrase = "word"});
    const Certificate strange = other.sign("strange");
    const auto showing = [&](const Certificate& shown) {
        return Tls{.authorities = authority.file(), .certificate = shown.certificate, .key = shown.key};
    };
    EXPECT_EQ(said(front, showing(own), {.keyPassphrase = "word"}).words, "no error");
    for (const char* wrong : {"", "other"}) {
        const Said locked = said(front, showing(own), {.keyPassphrase = wrong});
        EXPECT_EQ(locked.words, "The certificate of this computer cannot be used with its key.");
        EXPECT_EQ(locked.lastStep, "Encryption");
    }
    EXPECT_EQ(said(front, showing({own.certificate, strange.key}), {.keyPassphrase = "word"}).words,
              "The certificate of this computer cannot be used with its key.");
    const Said without = said(front, {.authorities = authority.file()});
    EXPECT_EQ(without.words,
              "The archive wants a certificate of this computer, and accepts none that it got.");
    EXPECT_EQ(without.lastStep, "Encryption");
    EXPECT_EQ(said(front, showing(strange)).words, without.words);
}

}  // namespace
}  // namespace macula::net::test
