#include "net/sources/source_list.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "net/sources/source_json.h"

namespace macula::net {

namespace {

namespace fs = std::filesystem;

Source hospital() {
    Source source;
    source.name = "Hospital";
    source.peer = DimsePeer{.host = "pacs.example", .port = 11112, .calledAe = "ARCHIVE"};
    return source;
}

Source cloud() {
    Source source;
    source.name = "Cloud";
    source.answerTimeout = std::chrono::seconds(20);
    WebPeer peer;
    peer.url = "https://pacs.example/dicom-web";
    peer.signIn = SignIn::basic;
    peer.user = "reader";
    peer.tls.authorities = "/etc/ssl/own.pem";
    source.peer = peer;
    return source;
}

class SourceListTest : public ::testing::Test {
  protected:
    SourceListTest() : folder_(fs::temp_directory_path() / ("macula-sources-" + std::to_string(getpid()))) {
        fs::remove_all(folder_);
        fs::create_directories(folder_ / "administrator");
        files_ = {folder_ / "administrator" / "sources.json", folder_ / "data" / "sources.json",
                  folder_ / "data" / "secrets.json"};
    }
    ~SourceListTest() override { fs::remove_all(folder_); }

    SourceList list() {
        auto read = SourceList::read(files_);
        EXPECT_TRUE(read) << (read ? Text() : read.error().message);
        return *read;
    }
    void administrate(const std::vector<Source>& sources) {
        std::ofstream(files_.managed) << toJson(sources).dump();
    }
    static void expectUsage(const Result<void>& result, std::string_view words) {
        ASSERT_FALSE(result);
        EXPECT_EQ(result.error().code, ErrorCode::usage);
        EXPECT_NE(result.error().message.english().find(words), std::string::npos) << result.error().message;
        EXPECT_FALSE(result.error().hint.empty());
    }

    fs::path folder_;
    SourceFiles files_;
};

TEST_F(SourceListTest, WhatIsPutIsThereForTheNextProgram) {
    EXPECT_TRUE(list().all().empty());
    SourceList first = list();
    ASSERT_TRUE(first.put(hospital()));
    ASSERT_TRUE(first.put(cloud()));
    const SourceList second = list();
    ASSERT_EQ(second.all().size(), 2u);
    EXPECT_EQ(toJson(second.all()), toJson(std::vector{hospital(), cloud()}));
    const auto found = second.find("cloud");  // in lower case
    ASSERT_TRUE(found);
    EXPECT_EQ(found->answerTimeout, std::chrono::seconds(20));
    EXPECT_EQ(std::get<WebPeer>(found->peer).user, "reader");
}

TEST_F(SourceListTest, TwoProgramsDoNotUndoEachOther) {
    SourceList first = list();
    SourceList second = list();
    ASSERT_TRUE(first.put(hospital()));
    ASSERT_TRUE(second.put(cloud()));
    EXPECT_EQ(list().all().size(), 2u);
}

TEST_F(SourceListTest, TheAdministratorsCannotBeChanged) {
    administrate({hospital()});
    SourceList all = list();
    ASSERT_EQ(all.all().size(), 1u);
    EXPECT_TRUE(all.all().front().isManaged);
    expectUsage(all.put(hospital()), "administrator");
    expectUsage(all.remove("Hospital"), "administrator");
    ASSERT_TRUE(all.put(cloud()));
    EXPECT_EQ(list().all().size(), 2u);
}

TEST_F(SourceListTest, PasswordsArePrivateAndGoWithTheirArchive) {
    SourceList all = list();
    ASSERT_TRUE(all.put(cloud()));
    ASSERT_TRUE(all.keep(cloud(), {.password = "secret words"}));
    EXPECT_EQ(list().secretsOf(cloud())->password, "secret words");
    EXPECT_EQ(fs::status(files_.secrets).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_EQ(fs::status(files_.own).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    std::ifstream own(files_.own);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(own), {}).find("secret"), std::string::npos);

    ASSERT_TRUE(all.remove("Cloud"));
    EXPECT_TRUE(list().secretsOf(cloud())->password.empty());
}

TEST_F(SourceListTest, PasswordsThatOthersCanReadAreNotUsed) {
    SourceList all = list();
    ASSERT_TRUE(all.put(cloud()));
    ASSERT_TRUE(all.keep(cloud(), {.password = "secret words"}));
    fs::permissions(files_.secrets, fs::perms::others_read, fs::perm_options::add);
    const auto secrets = all.secretsOf(cloud());
    ASSERT_FALSE(secrets);
    EXPECT_EQ(secrets.error().code, ErrorCode::inputNotUsable);
}

TEST_F(SourceListTest, SettingsThatCannotWorkAreRefused) {
    SourceList all = list();
    Source source = hospital();
    std::get<DimsePeer>(source.peer).calledAe = "SEVENTEEN LETTERS";
    expectUsage(all.put(source), "AE title");
    source = hospital();
    std::get<DimsePeer>(source.peer).host.clear();
    expectUsage(all.put(source), "host");
    source = hospital();
    std::get<DimsePeer>(source.peer).retrieve = Retrieve::move;
    expectUsage(all.put(source), "C-MOVE");
    source = cloud();
    std::get<WebPeer>(source.peer).url = "ftp://pacs.example";
    expectUsage(all.put(source), "https://");
    source = cloud();
    source.name = "a/b";
    expectUsage(all.put(source), "name");
    EXPECT_FALSE(fs::exists(files_.own));
}

TEST_F(SourceListTest, AFileThatIsWrongSaysWhatAndIsKept) {
    const std::pair<const char*, const char*> wrong[] = {
        {"{", "not JSON"},
        {"[]", "not JSON"},
        {R"({"version": 2, "sources": []})", "version"},
        {R"({"version": 1, "sources": [1]})", "not an object"},
        {R"({"version": 1, "sources": [{"name": "A"}]})", "either"},
        {R"({"version": 1, "sources": [{"name": "A", "dimse": {"host": "h", "calledAE": "X"}}]})",
         "calledAE"},
        {R"({"version": 1, "sources": [{"name": "A", "dimse": {"host": "h", "calledAe": "X", "port": 70000}}]})",
         "port"},
        {R"({"version": 1, "sources": [{"name": "A", "dimse": {"host": "h", "calledAe": "X", "port": -1}}]})",
         "port"},
        {R"({"version": 1, "sources": [{"name": "A", "answerTimeout": 0, "dimse": {"host": "h", "calledAe": "X"}}]})",
         "answerTimeout"},
        {R"({"version": 1, "sources": [{"name": "A", "dicomweb": {"url": "https://h", "signIn": "magic"}}]})",
         "signIn"},
        {R"({"version": 1, "sources": [{"name": "A", "dicomweb": {"url": "https://h"}}, {"name": "A", "dicomweb": {"url": "https://i"}}]})",
         "same name"},
    };
    for (const auto& [text, words] : wrong) {
        std::ofstream(files_.managed) << text;
        const auto read = SourceList::read(files_);
        ASSERT_FALSE(read) << text;
        EXPECT_EQ(read.error().code, ErrorCode::inputNotUsable) << text;
        EXPECT_NE(read.error().message.english().find(words), std::string::npos) << read.error().message;
        EXPECT_TRUE(fs::exists(files_.managed));
    }
}

}  // namespace

}  // namespace macula::net
