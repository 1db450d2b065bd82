// TLS with archives of the web: whom this computer trusts, and how it shows who it is. Orthanc is the server.
#include <gtest/gtest.h>

#include "dicom/support.h"
#include "net/certificates.h"
#include "net/connect.h"
#include "net/servers.h"

namespace macula::net::test {
namespace {

using dicom::test::TemporaryFolder;

class WebTls : public testing::Test {
  protected:
    void SetUp() override { SKIP_WITHOUT_PROGRAM("Orthanc"); }

    // What a search says, and the step at which a test of the archive ends.
    struct Said {
        std::string words = "no error";
        std::string lastStep;
        bool isUsage = false;
    };
    static Said said(const Orthanc& orthanc, const Tls& tls, const Secrets& secrets = {}) {
        Source source;
        source.peer = WebPeer{.url = orthanc.webUrl(), .tls = tls};
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
};

TEST_F(WebTls, ACertificateMustBeTrustedAndOfThisHostAndTime) {
    const Authority authority(folder_ / "tls");
    OrthancOptions options;
    options.httpTls = authority.sign("expired", {.isExpired = true});
    {
        const Said expired = said(Orthanc(options), {.authorities = authority.file()});
        EXPECT_EQ(expired.words, "The archive's certificate is not valid at this time.");
        EXPECT_EQ(expired.lastStep, "Encryption");
    }
    options.httpTls = authority.sign("other", {.host = "pacs.example.org"});
    {
        const Said other = said(Orthanc(options), {.authorities = authority.file()});
        EXPECT_EQ(other.words, "The archive's certificate is for another host.");
        EXPECT_EQ(other.lastStep, "Encryption");
    }
    options.httpTls = authority.sign("right");
    const Orthanc orthanc(options);
    EXPECT_EQ(said(orthanc, {.authorities = authority.file()}).words, "no error");
    EXPECT_EQ(said(orthanc, {}).words,
              "The archive's certificate is signed by nobody whom this computer trusts.");
    EXPECT_EQ(said(orthanc, {.authorities = options.httpTls->key}).words,
              "The file or folder of trusted authorities cannot be read.");
    EXPECT_TRUE(said(orthanc, {.authorities = folder_ / "missing"}).isUsage);
    // A folder of hashed certificates.
    std::filesystem::create_directory(folder_ / "hashed");
    std::filesystem::copy_file(authority.file(), folder_ / "hashed" / "one.pem");
    const Ran hashed =
        ran({programNamed("openssl"), "rehash", (folder_ / "hashed").string()}, folder_.path());
    ASSERT_EQ(hashed.exitCode, 0) << hashed.output;
    EXPECT_EQ(said(orthanc, {.authorities = folder_ / "hashed"}).words, "no error");
}

TEST_F(WebTls, ACertificateOfOursIsShown) {
    const Authority authority(folder_ / "tls");
    const Authority other(folder_ / "other");
    OrthancOptions options;
    options.httpTls = authority.sign("server");
    options.more = {{"SslVerifyPeers", true}, {"SslTrustedClientCertificates", authority.file().string()}};
    const Orthanc orthanc(options);
    const Certificate own = authority.sign("own", {.keyPassphrase = "word"});
    const Certificate strange = other.sign("strange");
    const auto with = [&](const Certificate& shown) {
        return Tls{.authorities = authority.file(), .certificate = shown.certificate, .key = shown.key};
    };
    EXPECT_EQ(said(orthanc, with(own), {.keyPassphrase = "word"}).words, "no error");
    for (const char* wrong : {"", "other"}) {
        const Said locked = said(orthanc, with(own), {.keyPassphrase = wrong});
        EXPECT_EQ(locked.words, "The certificate of this computer cannot be used with its key.");
        EXPECT_EQ(locked.lastStep, "Encryption");
    }
    EXPECT_EQ(said(orthanc, with({own.certificate, strange.key}), {.keyPassphrase = "word"}).words,
              "The certificate of this computer cannot be used with its key.");
    const Said without = said(orthanc, {.authorities = authority.file()});
    EXPECT_EQ(without.words,
              "The archive wants a certificate of this computer, and accepts none that it got.");
    EXPECT_EQ(without.lastStep, "Encryption");
    EXPECT_EQ(said(orthanc, with(strange)).words, without.words);
}

}  // namespace
}  // namespace macula::net::test
