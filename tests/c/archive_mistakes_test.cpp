// Archives through the C interface: those that are set up, wrong settings, and mistakes of a host.
#include <sys/stat.h>

#include <cstdlib>
#include <fstream>

#include "c/archive_fixture.h"

namespace macula::test {
namespace {

namespace fs = std::filesystem;
using net::test::Orthanc;
using nlohmann::json;

constexpr const char* kPassword = "correct-horse";
constexpr const char* kWrong = "wrong-battery";

// No text of the last error holds a password.
void expectDiscreet() {
    const macula_error error = lastError();
    for (const char* text : {error.message, error.advice, error.place})
        for (const char* secret : {kPassword, kWrong})
            EXPECT_EQ(std::string(text).find(secret), std::string::npos) << text;
}

class CArchiveSettings : public ::testing::Test {
  protected:
    static fs::path dataFolder() { return fs::path(std::getenv("XDG_DATA_HOME")) / "macula"; }
    // As `macula pacs add` does.
    static void setUp(const json& source, const json& secrets) {
        fs::create_directories(dataFolder());
        std::ofstream(dataFolder() / "sources.json") << json{{"version", 1}, {"sources", {source}}};
        std::ofstream(dataFolder() / "secrets.json") << secrets;
        chmod((dataFolder() / "sources.json").c_str(), 0600);
        chmod((dataFolder() / "secrets.json").c_str(), 0600);
    }
    void TearDown() override {
        fs::remove(dataFolder() / "sources.json");
        fs::remove(dataFolder() / "secrets.json");
    }

    static Owned<macula_archive> opened(const char* name, const macula_secrets* secrets = nullptr) {
        macula_archive* made = nullptr;
        EXPECT_EQ(macula_archive_open(name, secrets, &made), MACULA_DONE) << lastError().message;
        return Owned<macula_archive>(made);
    }
    static macula_status find(const Owned<macula_archive>& archive) {
        const char* found = nullptr;
        return macula_archive_find(archive.get(), nullptr, nullptr, &found);
    }
    // The step that fails, the last.
    static json failedStep(const json& source) {
        const Owned<macula_archive> archive = archiveOf(source);
        const json steps =
            answered([&](const char** told) { return macula_archive_test(archive.get(), nullptr, told); });
        EXPECT_FALSE(steps.empty());
        expectError(find(archive), MACULA_ARCHIVE);
        return steps.empty() || steps.back()["passed"] ? json() : steps.back();
    }
};

TEST_F(CArchiveSettings, AnArchiveIsOpenedByItsNameWithThePasswordThatIsKept) {
    SKIP_WITHOUT_PROGRAM("Orthanc");
    const Orthanc server({.user = "reader", .password = kPassword});
    json source = webAt(server.webUrl());
    source["dicomweb"]["signIn"] = "basic";
    source["dicomweb"]["user"] = "reader";
    setUp(source, {{"Cloud", {{"password", kPassword}}}});

    const json list = answered([](const char** told) { return macula_archives(told); });
    ASSERT_EQ(list.size(), 1u) << list;
    EXPECT_EQ(list[0]["name"], "Cloud");
    EXPECT_EQ(list[0]["isManaged"], false);
    EXPECT_EQ(list[0]["dicomweb"]["url"], server.webUrl());
    EXPECT_EQ(list.dump().find(kPassword), std::string::npos);

    EXPECT_EQ(find(opened("cloud")), MACULA_DONE) << lastError().message << lastError().advice;
    auto secrets = sized<macula_secrets>();
    secrets.password = kWrong;
    expectError(find(opened("Cloud", &secrets)), MACULA_ARCHIVE);
    expectDiscreet();
    secrets.password = nullptr;  // given, and none: not the one that is kept
    expectError(find(opened("Cloud", &secrets)), MACULA_ARCHIVE);

    macula_archive* made = nullptr;
    secrets.password = kPassword;
    ASSERT_EQ(macula_archive_of_json(source.dump().c_str(), &secrets, &made), MACULA_DONE);
    EXPECT_EQ(find(Owned<macula_archive>(made)), MACULA_DONE) << lastError().message;
    for (const auto& file : fs::recursive_directory_iterator(dataFolder())) {
        if (!file.is_regular_file()) continue;
        std::ifstream stream(file.path());
        const std::string text{std::istreambuf_iterator<char>(stream), {}};
        EXPECT_EQ(text.find(kWrong), std::string::npos) << file.path() << " keeps what a host gave";
    }
}

TEST_F(CArchiveSettings, OneThatIsNotSetUpIsToldWithThoseThatAre) {
    macula_archive* made = nullptr;
    expectError(macula_archive_open("Hospital", nullptr, &made), MACULA_USAGE);
    EXPECT_EQ(answered([](const char** told) { return macula_archives(told); }), json::array());
    setUp(dimseAt(104, "ARCHIVE"), json::object());
    EXPECT_EQ(macula_archive_open("hospital", nullptr, &made), MACULA_DONE) << lastError().message;
    macula_archive_close(made);
    for (const char* name : {"Clinic", "", static_cast<const char*>(nullptr)}) {
        expectError(macula_archive_open(name, nullptr, &made), MACULA_USAGE);
        EXPECT_EQ(made, nullptr);
        EXPECT_NE(std::string(lastError().advice).find("Hospital"), std::string::npos);
    }
}

TEST_F(CArchiveSettings, FilesThatCannotBeUsedAreNamed) {
    setUp(dimseAt(104, "ARCHIVE"), {{"Hospital", {{"password", kPassword}}}});
    chmod((dataFolder() / "secrets.json").c_str(), 0644);
    macula_archive* made = nullptr;
    expectError(macula_archive_open("Hospital", nullptr, &made), MACULA_INPUT);
    EXPECT_EQ(lastError().place, (dataFolder() / "secrets.json").string());
    expectDiscreet();
    std::ofstream(dataFolder() / "sources.json") << "{";
    const char* list = "not touched";
    expectError(macula_archives(&list), MACULA_INPUT);
    EXPECT_EQ(list, nullptr);
    EXPECT_EQ(lastError().place, (dataFolder() / "sources.json").string());
}

TEST_F(CArchiveSettings, EachTroubleHasItsStepAndItsSentence) {
    SKIP_WITHOUT_PROGRAM("Orthanc");
    const Orthanc server;
    json source = dimseAt(server.dicomPort(), server.title());
    const Owned<macula_archive> archive = archiveOf(source);
    const json steps =
        answered([&](const char** told) { return macula_archive_test(archive.get(), nullptr, told); });
    EXPECT_GE(steps.size(), 5u);
    for (const json& step : steps) EXPECT_EQ(step["passed"], true) << step;

    source["dimse"]["calledAe"] = "SOMEBODY";
    const json titles = failedStep(source);
    EXPECT_EQ(titles["name"], "AE titles") << titles;
    EXPECT_NE(titles["advice"], "");
    source["dimse"]["port"] = net::test::freePort();
    EXPECT_EQ(failedStep(source)["name"], "Port");
    EXPECT_EQ(failedStep(webAt("http://127.0.0.1:" + std::to_string(net::test::freePort())))["name"],
              "Connection");
}

TEST_F(CArchiveSettings, SettingsThatCannotWorkAreRefused) {
    const auto refused = [](const std::string& text) {
        macula_archive* made = nullptr;
        EXPECT_NE(macula_archive_of_json(text.c_str(), nullptr, &made), MACULA_DONE) << text;
        EXPECT_EQ(made, nullptr);
        EXPECT_STRNE(lastError().advice, "") << text;
        expectDiscreet();
        return std::string(lastError().message);
    };
    for (const char* text : {"", "{", "[]", "7", "{}", R"({"name": "A"})", "\xFF"}) refused(text);
    json source = dimseAt(104, "ARCHIVE");
    source["dimse"]["password"] = kPassword;  // belongs elsewhere
    EXPECT_NE(refused(source.dump()).find("\"password\""), std::string::npos);
    source["dimse"].erase("password");
    source["dimse"]["calledAe"] = "A TITLE OF MORE THAN SIXTEEN";
    refused(source.dump());
    refused(webAt("ftp://pacs.example.org").dump());
    macula_archive* made = nullptr;
    expectError(macula_archive_of_json(nullptr, nullptr, &made), MACULA_USAGE);
}

// Nobody listens: each of these must be noticed before anything is asked.
class CArchiveMistakes : public ::testing::Test {
  protected:
    Owned<macula_archive> archive_ = archiveOf(dimseAt(net::test::freePort(), "ARCHIVE"));
    const char* json_ = "not touched";
    macula_fetched fetched_ = sized<macula_fetched>();
    macula_sent sent_ = sized<macula_sent>();
};

TEST_F(CArchiveMistakes, WhatIsNullIsRefused) {
    const char* const path[]{"/nowhere"};
    const char* const nothing[]{nullptr};
    auto fetch = sized<macula_fetch>();
    fetch.study_uid = "2.25.1";
    expectError(macula_archives(nullptr), MACULA_USAGE);
    expectError(macula_archive_open("Hospital", nullptr, nullptr), MACULA_USAGE);
    expectError(macula_archive_of_json("{}", nullptr, nullptr), MACULA_USAGE);
    expectError(macula_archive_test(archive_.get(), nullptr, nullptr), MACULA_USAGE);
    expectError(macula_archive_test(nullptr, nullptr, &json_), MACULA_USAGE);
    EXPECT_EQ(json_, nullptr);
    expectError(macula_archive_find(nullptr, nullptr, nullptr, &json_), MACULA_USAGE);
    expectError(macula_archive_find(archive_.get(), nullptr, nullptr, nullptr), MACULA_USAGE);
    expectError(macula_archive_series(archive_.get(), nullptr, nullptr, &json_), MACULA_USAGE);
    expectError(macula_archive_series(nullptr, "2.25.1", nullptr, &json_), MACULA_USAGE);
    expectError(macula_archive_fetch(nullptr, &fetch, nullptr, &fetched_), MACULA_USAGE);
    expectError(macula_archive_fetch(archive_.get(), nullptr, nullptr, &fetched_), MACULA_USAGE);
    expectError(macula_archive_fetch(archive_.get(), &fetch, nullptr, nullptr), MACULA_USAGE);
    expectError(macula_archive_send(nullptr, path, 1, nullptr, &sent_), MACULA_USAGE);
    expectError(macula_archive_send(archive_.get(), nullptr, 1, nullptr, &sent_), MACULA_USAGE);
    expectError(macula_archive_send(archive_.get(), path, 0, nullptr, &sent_), MACULA_USAGE);
    expectError(macula_archive_send(archive_.get(), nothing, 1, nullptr, &sent_), MACULA_USAGE);
    expectError(macula_archive_send(archive_.get(), path, 1, nullptr, nullptr), MACULA_USAGE);
    expectError(macula_archive_refusal(archive_.get(), 0, nullptr), MACULA_USAGE);
    EXPECT_EQ(macula_archive_note(nullptr, 0), nullptr);
    EXPECT_EQ(macula_archive_note(archive_.get(), 0), nullptr);
    macula_archive_close(nullptr);
}

TEST_F(CArchiveMistakes, WrongSizesAreRefused) {
    auto fetch = sized<macula_fetch>();
    fetch.study_uid = "2.25.1";
    auto query = sized<macula_query>();
    auto secrets = sized<macula_secrets>();
    auto refusal = sized<macula_refusal>();
    fetch.size = query.size = secrets.size = refusal.size = fetched_.size = sent_.size = 3;
    macula_archive* made = nullptr;
    const std::string source = dimseAt(104, "ARCHIVE").dump();
    expectError(macula_archive_of_json(source.c_str(), &secrets, &made), MACULA_USAGE);
    expectError(macula_archive_find(archive_.get(), &query, nullptr, &json_), MACULA_USAGE);
    expectError(macula_archive_refusal(archive_.get(), 0, &refusal), MACULA_USAGE);
    const char* const path[]{"/nowhere"};
    expectError(macula_archive_send(archive_.get(), path, 1, nullptr, &sent_), MACULA_USAGE);
    expectError(macula_archive_fetch(archive_.get(), &fetch, nullptr, &fetched_), MACULA_USAGE);
    fetched_.size = sizeof fetched_;
    expectError(macula_archive_fetch(archive_.get(), &fetch, nullptr, &fetched_), MACULA_USAGE);
    EXPECT_NE(std::string(lastError().message).find(" 3 bytes"), std::string::npos);
}

TEST_F(CArchiveMistakes, WhatIsNoUidIsRefused) {
    auto fetch = sized<macula_fetch>();
    for (const char* uid : {"", "*", "2.25.1\\2.25.2", "DOE^JANE"}) {
        fetch.study_uid = uid;
        expectError(macula_archive_fetch(archive_.get(), &fetch, nullptr, &fetched_), MACULA_USAGE);
        EXPECT_EQ(std::string(lastError().message).find("DOE"), std::string::npos);
        expectError(macula_archive_series(archive_.get(), uid, nullptr, &json_), MACULA_USAGE);
    }
    fetch.study_uid = "2.25.1";
    fetch.series_count = 2;
    expectError(macula_archive_fetch(archive_.get(), &fetch, nullptr, &fetched_), MACULA_USAGE);
    for (const char* second : {"*", static_cast<const char*>(nullptr)}) {
        const char* const series[]{"2.25.2", second};
        fetch.series_uids = series;
        expectError(macula_archive_fetch(archive_.get(), &fetch, nullptr, &fetched_), MACULA_USAGE);
    }
}

TEST_F(CArchiveMistakes, WhatIsNoDateIsRefused) {
    for (const char* day : {"yesterday", "2026-1-1", "202601", "2026010*"}) {
        for (const char* macula_query::*member :
             {&macula_query::date_from, &macula_query::date_to, &macula_query::patient_birth_date}) {
            auto query = sized<macula_query>();
            query.*member = day;
            expectError(macula_archive_find(archive_.get(), &query, nullptr, &json_), MACULA_USAGE);
        }
    }
    auto query = sized<macula_query>();
    query.study_uid = "2.25.*";
    expectError(macula_archive_find(archive_.get(), &query, nullptr, &json_), MACULA_USAGE);
}

TEST_F(CArchiveMistakes, ClosedHandlesAndThoseOfAnotherKindAreRefused) {
    macula_archive* const closed = archive_.release();
    macula_archive_close(closed);
    macula_archive_close(closed);
    expectError(macula_archive_find(closed, nullptr, nullptr, &json_), MACULA_USAGE);
    const auto study = TwoBalls().study();
    auto* const wrong = reinterpret_cast<macula_archive*>(study.get());
    expectError(macula_archive_find(wrong, nullptr, nullptr, &json_), MACULA_USAGE);
    EXPECT_EQ(macula_archive_note(wrong, 0), nullptr);
    macula_archive_close(wrong);
    EXPECT_EQ(macula_study_volumes(study.get()), 1u) << "nothing was closed";
}

TEST_F(CArchiveMistakes, AFolderThatCannotBeMadeIsAnOutput) {
    const dicom::test::TemporaryFolder folder;
    std::ofstream(folder / "file") << "in the way";
    const std::string into = (folder / "file" / "below").string();
    auto fetch = sized<macula_fetch>();
    fetch.study_uid = "2.25.1";
    fetch.into = into.c_str();
    expectError(macula_archive_fetch(archive_.get(), &fetch, nullptr, &fetched_), MACULA_OUTPUT);
    EXPECT_EQ(lastError().place, into);
}

}  // namespace
}  // namespace macula::test
