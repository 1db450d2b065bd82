// macula sessions list, show and audit, and what all of them say where nothing is stored.
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "cli/sessions_fixture.h"

namespace macula::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Sessions = SessionsTest;

TEST_F(Sessions, AreListed) {
    fill();
    const json list = jsonOf({"list"});
    ASSERT_EQ(list["studies"].size(), 2u);
    EXPECT_EQ(list["studies"][0]["identity"], bert()) << "opened last";
    const json& study = list["studies"][1];
    EXPECT_EQ(study["identity"], anna());
    EXPECT_EQ(study["readable"], "CT Abdomen");
    EXPECT_EQ(study["lastOpened"], "2023-11-14T22:13:20.000Z");
    EXPECT_EQ(study["models"], 2);
    EXPECT_EQ(study["modelBytes"], 2'000'000);
    EXPECT_EQ(study["documents"], 1);
    EXPECT_EQ(list["models"], 3);
    EXPECT_EQ(list["modelsWithoutStudy"], 1);

    const Ran text = sessions({"list"}, {"TZ=CET-1"});
    EXPECT_EQ(text.exitCode, 0) << text.err;
    const std::string line = anna().substr(0, 12) + "  2023-11-14T23:13:20+01:00  2 models (2.0 MB)";
    EXPECT_NE(text.out.find(line), std::string::npos) << text.out;
    EXPECT_NE(text.out.find("1 stored state    CT Abdomen\n"), std::string::npos) << text.out;
    EXPECT_NE(text.out.find("MR?[2J Head"), std::string::npos) << text.out;
    EXPECT_EQ(text.out.find('\x1b'), std::string::npos) << "text of a file steers the terminal";
    EXPECT_EQ(text.out.find(anna()), std::string::npos) << "all of its digits";
}

TEST_F(Sessions, OfAFolderThatIsNotThereAreNone) {
    for (const char* verb : {"list", "verify", "audit", "gc"}) {
        const Ran ran = sessions({verb});
        EXPECT_EQ(ran.exitCode, 0) << verb << ran.err;
        EXPECT_NE(ran.out.find("Nothing is stored yet in " + store()), std::string::npos) << ran.out;
        EXPECT_TRUE(jsonOf({verb}).is_object());
    }
    EXPECT_EQ(jsonOf({"list"})["studies"], json::array());
    EXPECT_EQ(jsonOf({"verify"})["sound"], true);
    EXPECT_EQ(jsonOf({"purge", "--all", "--yes"})["studies"], 0);
    expectRefused({"show", "0123"}, 2, "Nothing is stored yet.");
    expectRefused({"export", at("out")}, 2, "Nothing is stored yet.");
    expectRefused({"purge", "0123", "--yes"}, 2, "Nothing is stored yet.");
    EXPECT_EQ(fileCount(), 0u) << "something was made";
    fs::create_directory(store());
    EXPECT_EQ(jsonOf({"list"})["studies"], json::array());
    EXPECT_EQ(fileCount(), 1u) << "something was made in an empty folder";
}

TEST_F(Sessions, AreSomebodyElsesWhereOtherFilesAre) {
    fs::create_directory(store());
    write("store/letter.txt", "milk, eggs");
    for (const std::string verb : {"list", "verify", "gc", "audit"})
        expectRefused({verb}, 3, "holds files of another program");
    EXPECT_EQ(fileCount("store"), 1u);
}

TEST_F(Sessions, OfAStudyAreShown) {
    fill();
    const json study = jsonOf({"show", anna().substr(0, 6)});
    EXPECT_EQ(study["identity"], anna());
    ASSERT_EQ(study["series"].size(), 1u);
    EXPECT_EQ(study["series"][0]["volumes"], json::array({session::test::digestOf("chest")}));
    ASSERT_EQ(study["models"].size(), 2u);
    EXPECT_EQ(study["models"][0]["parts"]["transfer-function"], session::test::digestOf("lung"))
        << "used last";
    EXPECT_EQ(study["models"][0]["bytes"], 600'000);
    EXPECT_EQ(study["models"][0]["saved"], "2023-11-14T22:13:20.000Z");
    EXPECT_TRUE(study["models"][0]["setAside"].is_null());
    ASSERT_EQ(study["documents"].size(), 1u);
    EXPECT_EQ(study["documents"][0]["kind"], "session");
    EXPECT_EQ(study["documents"][0]["name"], "last");

    std::string inCapitals = anna().substr(0, 8);
    std::ranges::transform(inCapitals, inCapitals.begin(), [](unsigned char c) { return std::toupper(c); });
    const Ran text = sessions({"show", inCapitals});
    EXPECT_EQ(text.exitCode, 0) << text.err;
    for (const char* words : {"CT Abdomen", "1 series", "2 models", "trainer 7, clip ", "1.4 MB, saved 20",
                              "1 stored state", "session  last  version 1"})
        EXPECT_NE(text.out.find(words), std::string::npos) << words << "\n" << text.out;
}

TEST_F(Sessions, OfWhatIsNoStudyAreRefused) {
    fill();
    expectRefused({"show", anna().substr(0, 3)}, 2, "first 4 or more of its digits");
    expectRefused({"show", "anna"}, 2, "first 4 or more of its digits");
    std::string other = anna();
    other.back() = other.back() == '0' ? '1' : '0';
    expectRefused({"show", other}, 2, "No stored study begins with " + other);
    expectRefused({"show", anna() + "0"}, 2, "No stored study begins with");
}

TEST_F(Sessions, OfTwoStudiesThatBeginAlikeAreAskedForByMoreDigits) {
    std::map<std::string, std::string> uidByDigits;
    std::string first;
    std::string second;
    for (int i = 0; second.empty(); ++i) {
        const std::string uid = "1.2." + std::to_string(i);
        const auto [place, isNew] = uidByDigits.emplace(session::studyIdentity(uid).substr(0, 4), uid);
        if (isNew) continue;
        first = place->second;
        second = uid;
    }
    for (const std::string& uid : {first, second})
        ASSERT_TRUE(session::test::isOk(open().recordOpened(opened(uid, uid))));
    const std::string identity = session::studyIdentity(second);
    expectRefused({"show", identity.substr(0, 4)}, 2, "2 studies begin with " + identity.substr(0, 4));
    expectRefused({"purge", identity.substr(0, 4), "--yes"}, 2, identity.substr(0, 12));
    EXPECT_EQ(jsonOf({"list"})["studies"].size(), 2u);
    EXPECT_EQ(jsonOf({"show", identity.substr(0, 12)})["identity"], identity);
}

TEST_F(Sessions, HaveAnAuditTrail) {
    fill();
    const json trail = jsonOf({"audit"});
    ASSERT_EQ(trail["entries"].size(), 3u);
    EXPECT_EQ(trail["entries"][0]["action"], "opened");
    EXPECT_EQ(trail["entries"][0]["kind"], "study");
    EXPECT_EQ(trail["entries"][0]["subject"], anna());
    EXPECT_EQ(trail["entries"][2]["at"], "2023-11-15T22:13:20.000Z");
    const json last = jsonOf({"audit", "--last", "1"});
    ASSERT_EQ(last["entries"].size(), 1u);
    EXPECT_EQ(last["entries"][0]["subject"], bert());
    const Ran text = sessions({"audit"}, {"TZ=UTC0"});
    EXPECT_NE(text.out.find("2023-11-14T22:13:20+00:00  opened    study     " + anna().substr(0, 12)),
              std::string::npos)
        << text.out;
    expectRefused({"audit", "--last", "0"}, 2, "--last");
}

// No test comes near what the person who runs it has stored.
TEST_F(Sessions, AreWhereTheEnvironmentSays) {
    const char* data = std::getenv("XDG_DATA_HOME");
    ASSERT_NE(data, nullptr);
    EXPECT_TRUE(std::string(data).starts_with(fs::temp_directory_path().string())) << data;
    const Ran none = runMacula({"sessions", "list"}, {"XDG_DATA_HOME=" + at("data")});
    EXPECT_NE(none.out.find("Nothing is stored yet in " + at("data/macula/sessions")), std::string::npos);
    fill();
    const Ran chosen = runMacula({"sessions", "list", "--json"}, {"MACULA_SESSIONS=" + store()});
    EXPECT_EQ(parsed(chosen.out)["studies"].size(), 2u);
}

}  // namespace
}  // namespace macula::cli
