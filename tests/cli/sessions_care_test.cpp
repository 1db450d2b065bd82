// macula sessions verify and gc: damage is found and told, and so is what is done about it.
#include <filesystem>

#include "cli/sessions_fixture.h"

namespace macula::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class SessionsCare : public SessionsTest {
  protected:
    // Of a call that exits so.
    json verified(int exitCode) const {
        const Ran ran = sessions({"verify", "--json"});
        EXPECT_EQ(ran.exitCode, exitCode) << ran.err;
        EXPECT_EQ(ran.errorLines(), exitCode == 0 ? 0u : 1u) << ran.err;
        return parsed(ran.out);
    }
};

TEST_F(SessionsCare, WhatIsSoundIsSaidToBe) {
    fill();
    const json report = verified(0);
    EXPECT_EQ(report["sound"], true);
    EXPECT_EQ(report["models"], 3);
    EXPECT_GT(report["rows"], 8);
    EXPECT_TRUE(report["rescued"].is_null());
    const Ran text = sessions({"verify"});
    EXPECT_NE(text.out.find(" rows and 3 models: all is sound."), std::string::npos) << text.out;
}

TEST_F(SessionsCare, ADamagedModelIsSetAsideAndTold) {
    fill();
    const auto file = fs::directory_iterator(at("store/models"))->path();
    std::string blob = readAll(file);
    blob.back() ^= 1;
    write(fs::relative(file, folder_).string(), blob);
    const json first = verified(3);
    EXPECT_EQ(first["sound"], false);
    EXPECT_EQ(first["databaseSound"], true);
    EXPECT_EQ(first["damagedModels"], 1);
    EXPECT_EQ(first["setAside"], 1);
    const json second = verified(0);
    EXPECT_EQ(second["models"], 2);
    EXPECT_EQ(second["setAside"], 1);
    EXPECT_EQ(jsonOf({"list"})["modelsSetAside"], 1);
}

TEST_F(SessionsCare, ADamagedDatabaseIsSetAsideAndToldOnce) {
    fill();
    damageDatabase();
    const Ran ran = sessions({"verify", "--json"});
    EXPECT_EQ(ran.exitCode, 3) << ran.err;
    EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
    EXPECT_NE(ran.err.find("macula: warning: The file of stored sessions was damaged."), std::string::npos)
        << ran.err;
    const json first = parsed(ran.out);
    EXPECT_EQ(first["sound"], false);
    EXPECT_EQ(first["rescued"]["models"], 3);
    EXPECT_EQ(first["damagedFolders"], 1);
    EXPECT_TRUE(fs::exists(first["rescued"]["folder"].get<std::string>()));
    EXPECT_EQ(verified(0)["damagedFolders"], 1);
    EXPECT_EQ(jsonOf({"list"})["studies"].size(), 2u);
}

TEST_F(SessionsCare, EveryVerbTellsOfADamagedDatabaseAndGoesOn) {
    fill();
    damageDatabase();
    const Ran ran = sessions({"list"});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_NE(ran.err.find("were rescued"), std::string::npos) << ran.err;
    EXPECT_NE(ran.out.find("CT Abdomen"), std::string::npos) << ran.out;
    EXPECT_EQ(sessions({"list"}).err, "");
}

TEST_F(SessionsCare, ANewerSchemaIsLeftAlone) {
    fill();
    constexpr std::size_t kUserVersion = 60;  // where a file of SQLite has it: 4 bytes, the highest first
    std::string text = readAll(at("store/sessions.db"));
    text[kUserVersion + 2] = '\x7f';
    write("store/sessions.db", text);
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"list"},
                                               {"show", anna()},
                                               {"verify"},
                                               {"gc"},
                                               {"audit"},
                                               {"purge", "--all", "--yes"},
                                               {"export", at("out")}})
        expectRefused(words, 3, "newer version of Macula");
    EXPECT_EQ(readAll(at("store/sessions.db")), text);
    EXPECT_FALSE(fs::exists(at("out")));
    fs::rename(at("store"), at("newer"));
    expectRefused({"import", at("newer")}, 3, "newer version of Macula");
}

TEST_F(SessionsCare, ModelsAboveTheCapAndLeftOversGo) {
    fill();
    write("store/models/" + session::test::digestOf("nobody's") + ".model", "left over");
    EXPECT_EQ(verified(0)["leftOvers"], 1);
    const json first = jsonOf({"gc", "--cap", "1.5MB"});
    EXPECT_EQ(first["evictedModels"], 1);
    EXPECT_EQ(first["evictedBytes"], 1'400'000) << "the one that was used first";
    EXPECT_EQ(first["modelBytesLeft"], 601'000);
    EXPECT_EQ(first["leftOvers"], 1);
    EXPECT_EQ(first["leftOverBytes"], 9);
    const json last = jsonOf({"audit", "--last", "1"})["entries"][0];
    EXPECT_EQ(last["action"], "deleted");
    EXPECT_EQ(last["kind"], "model");
    EXPECT_EQ(last["amount"], 1);
    const std::size_t told = jsonOf({"audit"})["entries"].size();
    const json second = jsonOf({"gc"});
    EXPECT_EQ(second["evictedModels"], 0) << "two gigabytes are enough";
    EXPECT_EQ(second["leftOvers"], 0);
    EXPECT_EQ(jsonOf({"audit"})["entries"].size(), told) << "nothing went";
    const Ran text = sessions({"gc", "--cap", "0B"});
    EXPECT_EQ(text.out, "Removed 2 models (0.6 MB) and no left-overs. 0 MB of models are left.\n");
    EXPECT_TRUE(fs::is_empty(at("store/models")));
}

TEST_F(SessionsCare, AModelThatIsOpenStays) {
    fill();
    session::Store other = open();
    const auto mark = session::test::valueOf(other.markOpen(session::test::keyOf("chest")));
    const Ran ran = sessions({"gc", "--cap", "0B", "--json"});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_EQ(parsed(ran.out)["modelBytesLeft"], 1'400'000);
    EXPECT_NE(ran.err.find("note: Models that are open stay"), std::string::npos) << ran.err;
}

TEST_F(SessionsCare, WhatIsNoSizeIsRefused) {
    for (const std::string size : {"2XB", "much", "0", "2", "1.5", "nan"})
        expectRefused({"gc", "--cap", size}, 2, size + " is no size: give a number with its unit");
    EXPECT_EQ(fileCount(), 0u);
}

}  // namespace
}  // namespace macula::cli
