// The storage provider with DCMTK's senders, as other machines have them.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <gtest/gtest.h>

#include <set>

#include "net/provider_support.h"
#include "net/servers.h"

namespace macula::net::test {

namespace {

using dicom::test::TemporaryFolder;

Ran echoed(std::uint16_t port, const std::vector<std::string>& more = {}) {
    const TemporaryFolder own;
    std::vector<std::string> command{programNamed("echoscu"), "-aec", "MACULA", "-aet", "CT1"};
    command.insert(command.end(), more.begin(), more.end());
    command.insert(command.end(), {"127.0.0.1", std::to_string(port)});
    return ran(command, own.path());
}

TEST(StoreProvider, AnswersDcmtksSenders) {
    SKIP_WITHOUT_PROGRAM("dcmsend");
    SKIP_WITHOUT_PROGRAM("echoscu");
    const TemporaryFolder folder;
    const auto files = writeStudy(folder.path(), {});
    const TestedProvider provider;
    const Ran echo = echoed(provider.port());
    EXPECT_EQ(echo.exitCode, 0) << echo.output;
    sendFolder(folder.path(), provider.port(), "MACULA");
    expectSameDatasets(provider.reception.receiver.files(), files);
    for (const InstanceKey& key : provider.reception.receiver.promises())
        EXPECT_EQ(key.studyInstanceUid, SmallStudy().studyUid);
    ASSERT_EQ(provider.reception.callers().size(), 2u);
    EXPECT_EQ(provider.reception.callers().front().ae, "CT1");
    EXPECT_EQ(provider.reception.callers().back().ae, "SENDER");
    EXPECT_EQ(provider.reception.callers().back().address, "127.0.0.1");
    EXPECT_EQ(provider.counts().kept, files.size());
    EXPECT_EQ(provider.counts().associations, 2u);
    EXPECT_TRUE(provider.turnedAway().empty());
}

// DCMTK's senders change what is not compressed; Macula does not.
TEST(StoreProvider, TakesEachEncodingAsItIs) {
    SKIP_WITHOUT_PROGRAM("dcmcjpls");
    const TemporaryFolder folder;
    std::map<std::string, std::filesystem::path> files;
    int i = 0;
    for (const char* syntax : {UID_LittleEndianImplicitTransferSyntax, UID_LittleEndianExplicitTransferSyntax,
                               UID_BigEndianExplicitTransferSyntax}) {
        const SmallStudy study{.studyUid = "2.25.8100" + std::to_string(i),
                               .seriesCount = 1,
                               .slices = 1,
                               .transferSyntaxUid = syntax};
        files.merge(writeStudy(folder / std::to_string(i++), study));
    }
    for (const auto& [uid, file] :
         writeStudy(folder / "plain", {.studyUid = "2.25.8200", .seriesCount = 1, .slices = 1})) {
        files[uid] = folder / "compressed";
        const Ran changed =
            ran({programNamed("dcmcjpls"), file.string(), files[uid].string()}, folder.path());
        ASSERT_EQ(changed.exitCode, 0) << changed.output;
    }
    const TestedProvider provider;
    std::vector<std::filesystem::path> paths;
    for (const auto& [uid, file] : files) paths.push_back(file);
    Progress progress;
    const auto sent = archiveAt(peerAt(provider.port(), "MACULA"))->send(paths, progress);
    ASSERT_TRUE(sent) << told(sent.error());
    EXPECT_EQ(sent->stored, 4u);
    expectSameDatasets(provider.reception.receiver.files(), files);
    for (const InstanceKey& key : provider.reception.receiver.promises())
        EXPECT_TRUE(key.studyInstanceUid.starts_with("2.25.8")) << "its study is not found in this encoding";
}

TEST(StoreProvider, SeveralSendAtOnce) {
    SKIP_WITHOUT_PROGRAM("dcmsend");
    const TemporaryFolder folder;
    const TestedProvider provider;
    std::map<std::string, std::filesystem::path> all;
    std::vector<std::unique_ptr<Program>> senders;
    for (int i = 0; i < 4; ++i) {
        const auto own = folder / std::to_string(i);
        all.merge(writeStudy(own, {.studyUid = "2.25.8300" + std::to_string(i)}));
        senders.push_back(std::make_unique<Program>(
            std::vector<std::string>{programNamed("dcmsend"), "--call", "MACULA", "--scan-directories",
                                     "--recurse", "127.0.0.1", std::to_string(provider.port()), own.string()},
            folder.path()));
    }
    for (const auto& sender : senders) EXPECT_EQ(sender->exitCode(), 0) << sender->output();
    expectSameDatasets(provider.reception.receiver.files(), all);
}

TEST(StoreProvider, MaculaSendsToItself) {
    const TemporaryFolder folder;
    const auto files = writeStudy(folder.path(), {});
    const TestedProvider provider;
    std::vector<std::filesystem::path> paths;
    for (const auto& [uid, file] : files) paths.push_back(file);
    Progress progress;
    const auto archive = archiveAt(peerAt(provider.port(), "MACULA"));
    for (const std::size_t hadAlready : {std::size_t{0}, files.size()}) {
        const auto sent = archive->send(paths, progress);
        ASSERT_TRUE(sent) << told(sent.error());
        EXPECT_EQ(sent->stored, files.size());
        EXPECT_EQ(provider.counts().hadAlready, hadAlready);
    }
    const auto commitments = archive->commit(paths, std::chrono::seconds(5), progress);
    ASSERT_FALSE(commitments) << "it is no archive";
    EXPECT_FALSE(archive->findStudies({}, progress));
}

class ProtectedProvider : public testing::Test {
  protected:
    StoreProviderOptions options() const {
        StoreProviderOptions options;
        const Certificate own = authority_.sign("provider");
        options.tls = {.isOn = true, .authorities = {}, .certificate = own.certificate, .key = own.key};
        return options;
    }
    std::string authorityFile() const { return authority_.file().string(); }

    TemporaryFolder folder_;
    Authority authority_{folder_.path()};
};

TEST_F(ProtectedProvider, ShowsItsCertificate) {
    SKIP_WITHOUT_PROGRAM("echoscu");
    const TestedProvider provider(options());
    EXPECT_NE(echoed(provider.port()).exitCode, 0) << "without TLS";
    const Ran trusted = echoed(provider.port(), {"+tla", "+cf", authorityFile()});
    EXPECT_EQ(trusted.exitCode, 0) << trusted.output;
    EXPECT_EQ(provider.counts().associations, 1u);
    ASSERT_EQ(provider.turnedAway().size(), 1u);
    EXPECT_EQ(provider.turnedAway().front().why, TurnedAway::Why::protection);
}

TEST_F(ProtectedProvider, AsksForCertificatesOfOthers) {
    SKIP_WITHOUT_PROGRAM("echoscu");
    StoreProviderOptions asking = options();
    asking.tls.authorities = authority_.file();
    const TestedProvider provider(asking);
    EXPECT_NE(echoed(provider.port(), {"+tla", "+cf", authorityFile()}).exitCode, 0) << "without one";
    const TemporaryFolder other;
    const Authority stranger(other.path());
    for (const Authority* signer : {&stranger, static_cast<const Authority*>(&authority_)}) {
        const Certificate theirs = signer->sign("sender");
        const Ran echo = echoed(provider.port(), {"+tls", theirs.key.string(), theirs.certificate.string(),
                                                  "+cf", authorityFile()});
        EXPECT_EQ(echo.exitCode == 0, signer == &authority_) << echo.output;
    }
    EXPECT_EQ(provider.counts().associations, 1u);
}

TEST(StoreProviderOptions, ThoseThatCannotWorkAreRefused) {
    FolderReception reception;
    const auto isRefused = [&](const std::function<void(StoreProviderOptions&)>& change) {
        StoreProviderOptions options;
        options.port = 0;
        change(options);
        const auto provider = StoreProvider::start(options, reception);
        if (provider) return false;
        EXPECT_EQ(provider.error().code, ErrorCode::usage);
        EXPECT_FALSE(provider.error().hint.empty());
        return true;
    };
    EXPECT_FALSE(isRefused([](StoreProviderOptions&) {}));
    EXPECT_TRUE(isRefused([](StoreProviderOptions& options) { options.ownAe = ""; }));
    EXPECT_TRUE(isRefused([](StoreProviderOptions& options) { options.ownAe = "SEVENTEEN_LETTERS"; }));
    EXPECT_TRUE(isRefused([](StoreProviderOptions& options) { options.address = ""; }));
    EXPECT_TRUE(isRefused([](StoreProviderOptions& options) { options.address = "0.0.0.0"; }));
    EXPECT_FALSE(isRefused([](StoreProviderOptions& options) { options.address = "localhost"; }));
    EXPECT_TRUE(isRefused([](StoreProviderOptions& options) {
        options.address = "198.51.100.1";  // of documentation: nobody's
        options.admitsAnyone = true;
    }));
    EXPECT_FALSE(isRefused([](StoreProviderOptions& options) {
        options.address = "";
        options.callers = {{"CT1", ""}};
    }));
    EXPECT_FALSE(isRefused([](StoreProviderOptions& options) {
        options.address = "";
        options.admitsAnyone = true;
    }));
    EXPECT_TRUE(isRefused([](StoreProviderOptions& options) { options.callers = {{"CT1", "pacs"}}; }));
    EXPECT_TRUE(isRefused([](StoreProviderOptions& options) { options.tls.isOn = true; }));
    const TestedProvider other;
    EXPECT_TRUE(isRefused([&](StoreProviderOptions& options) { options.port = other.port(); }));
}

}  // namespace

}  // namespace macula::net::test
