// macula sessions export and import.
#include <filesystem>

#include "cli/sessions_fixture.h"

namespace macula::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using SessionsCopy = SessionsTest;

TEST_F(SessionsCopy, GoesOutAndComesBack) {
    fill();
    const json out = jsonOf({"export", at("out/")});
    EXPECT_EQ(out["studies"], 2);
    EXPECT_EQ(out["models"], 3);
    EXPECT_EQ(out["documents"], 1);
    const json studies = jsonOf({"list"})["studies"];
    const auto before = fileCount("out");
    fs::remove_all(store());
    const json in = jsonOf({"import", at("out")});
    EXPECT_EQ(in["studies"], 2);
    EXPECT_EQ(in["models"], 3);
    EXPECT_EQ(in["skipped"], 0);
    EXPECT_EQ(jsonOf({"list"})["studies"], studies);
    EXPECT_EQ(jsonOf({"verify"})["sound"], true);
    EXPECT_EQ(fileCount("out"), before) << "the export was changed";
    const json again = jsonOf({"import", at("out")});
    EXPECT_EQ(again["models"], 0) << "what is stored is as new";
    EXPECT_EQ(again["skipped"], 4);
    EXPECT_EQ(jsonOf({"audit", "--last", "1"})["entries"][0]["action"], "imported");
}

TEST_F(SessionsCopy, SaysWhatItDid) {
    fill();
    const Ran ran = sessions({"export", at("out")});
    EXPECT_EQ(ran.out, "Copied 2 studies, 3 models and 1 stored state.\n");
    EXPECT_NE(ran.err.find("Wrote " + at("out") + " in "), std::string::npos) << ran.err;
}

TEST_F(SessionsCopy, ReplacesNothing) {
    fill();
    fs::create_directory(at("taken"));
    write("taken/letter.txt", "milk, eggs");
    expectRefused({"export", at("taken")}, 2, "there already");
    EXPECT_EQ(readAll(at("taken/letter.txt")), "milk, eggs");
    EXPECT_EQ(fileCount("taken"), 1u);
    expectRefused({"export", at("no/such/folder")}, 2, "does not exist");
    // The store would be refused from then on, as a folder of other files.
    for (const char* inside : {"store/out", "store/models/out"})
        expectRefused({"export", at(inside)}, 2, "inside of the stored sessions");
    EXPECT_EQ(jsonOf({"list"})["studies"].size(), 2u);
}

TEST_F(SessionsCopy, OfWhatIsNoExportIsRefused) {
    expectRefused({"import", at("missing")}, 3, "holds no exported sessions");
    EXPECT_EQ(fileCount(), 0u);
    fs::create_directory(at("letters"));
    write("letters/sessions.db", "milk, eggs");
    expectRefused({"import", at("letters")}, 3, "holds no exported sessions");
    fill();
    expectRefused({"import", store()}, 2, "the stored sessions themselves");
    EXPECT_EQ(jsonOf({"list"})["studies"].size(), 2u);
}

TEST_F(SessionsCopy, LeavesOutWhatIsDamagedAndSaysSo) {
    fill();
    fs::remove(fs::directory_iterator(at("store/models"))->path());
    const Ran ran = sessions({"export", at("out"), "--json"});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_EQ(parsed(ran.out)["models"], 2);
    EXPECT_EQ(parsed(ran.out)["damaged"], 1);
    EXPECT_NE(ran.err.find("macula: warning: Damaged entries were left out: 1."), std::string::npos)
        << ran.err;
}

// The key is pressed when the first of many models is being copied.
TEST_F(SessionsCopy, IsStoppedByCtrlC) {
    {
        session::Store many = open();
        for (std::uint32_t i = 0; i < 60; ++i)
            ASSERT_TRUE(session::test::isOk(many.saveModel(session::test::keyOf("chest", std::to_string(i)),
                                                           session::test::blobOf(i, 1'000'000))));
    }
    const Ran ran = runMaculaInterrupted(
        {"sessions", "export", at("out"), "--folder", store()},
        [](const std::string& err) { return err.find("Copying stored models") != std::string::npos; });
    EXPECT_EQ(ran.exitCode, 130) << ran.err;
    EXPECT_FALSE(fs::exists(at("out")));
    for (const auto& entry : fs::directory_iterator(folder_))
        EXPECT_EQ(entry.path().filename(), "store") << "a draft was left";
}

}  // namespace
}  // namespace macula::cli
