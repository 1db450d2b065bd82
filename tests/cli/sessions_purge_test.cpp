// macula sessions purge: deletes what was asked for, after a question, and nothing else.
#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "cli/sessions_fixture.h"

namespace macula::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class SessionsPurge : public SessionsTest {
  protected:
    std::size_t studies() const { return jsonOf({"list"})["studies"].size(); }

    // At a terminal, where somebody types that.
    Ran typing(const std::string& answer, std::vector<std::string> words) const {
        words.insert(words.begin(), "sessions");
        words.insert(words.end(), {"--folder", store()});
        const int screen = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
        if (screen < 0 || grantpt(screen) != 0 || unlockpt(screen) != 0) {
            ADD_FAILURE() << "there is no terminal";
            return {};
        }
        const int terminal = ::open(ptsname(screen), O_RDWR | O_NOCTTY | O_CLOEXEC);
        EXPECT_EQ(::write(screen, answer.data(), answer.size()), static_cast<ssize_t>(answer.size()));
        Ran ran = runMacula(words, {}, [terminal] {
            dup2(terminal, STDIN_FILENO);
            dup2(terminal, STDERR_FILENO);
        });
        close(terminal);
        std::vector<char> bytes(4096);
        // The end is an error: nobody has the terminal any more.
        for (ssize_t count = 0; (count = ::read(screen, bytes.data(), bytes.size())) > 0;)
            ran.err.append(bytes.data(), static_cast<std::size_t>(count));
        close(screen);
        return ran;
    }
};

TEST_F(SessionsPurge, NeedsYesWhereNobodyCanBeAsked) {
    fill();
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"purge", anna()}, {"purge", "--all"}, {"purge", "--unused-days", "1"}})
        expectRefused(words, 2, "--yes");
    EXPECT_EQ(studies(), 2u);
}

TEST_F(SessionsPurge, OfAStudyTakesAllOfItAndNothingElse) {
    fill();
    const json report = jsonOf({"purge", anna().substr(0, 8), "--yes"});
    EXPECT_EQ(report["studies"], 1);
    EXPECT_EQ(report["volumes"], 1);
    EXPECT_EQ(report["models"], 2);
    EXPECT_EQ(report["documents"], 1);
    EXPECT_EQ(report["damagedFolders"], 0);
    const json left = jsonOf({"list"});
    ASSERT_EQ(left["studies"].size(), 1u);
    EXPECT_EQ(left["studies"][0]["identity"], bert());
    EXPECT_EQ(left["modelsWithoutStudy"], 1);
    for (const auto& file : session::test::filesBelow(store()))
        EXPECT_EQ(readAll(fs::path(store()) / file).find("CT Abdomen"), std::string::npos) << file;
    const json last = jsonOf({"audit", "--last", "1"})["entries"][0];
    EXPECT_EQ(last["action"], "deleted");
    EXPECT_EQ(last["subject"], anna());
}

TEST_F(SessionsPurge, OfAllTakesFilesWithoutAStudyToo) {
    fill();
    const Ran ran = sessions({"purge", "--all", "--yes"});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_EQ(ran.out, "Deleted 2 studies, 3 volumes, 3 models and 1 stored state.\n");
    EXPECT_EQ(studies(), 0u);
    EXPECT_TRUE(fs::is_empty(at("store/models")));
    EXPECT_EQ(jsonOf({"audit", "--last", "1"})["entries"][0]["action"], "deleted");
}

TEST_F(SessionsPurge, OfTheUnusedLeavesWhatWasJustOpened) {
    fill();
    const session::StoreOptions today{.folder = store()};
    ASSERT_TRUE(session::test::isOk(
        session::test::valueOf(session::Store::open(today)).recordOpened(opened("7.8.9", "foot"))));
    const json report = jsonOf({"purge", "--unused-days", "30", "--yes"});
    EXPECT_EQ(report["studies"], 2);
    EXPECT_EQ(report["models"], 3);
    const json left = jsonOf({"list"})["studies"];
    ASSERT_EQ(left.size(), 1u);
    EXPECT_EQ(left[0]["identity"], session::studyIdentity("7.8.9"));
    EXPECT_EQ(jsonOf({"audit", "--last", "1"})["entries"][0]["action"], "expired");
}

// All was opened in 2023, and nothing since: that may be a clock that was put forward.
TEST_F(SessionsPurge, OfTheUnusedIsHeldWhereTheClockMayBeWrong) {
    fill();
    const Ran held = sessions({"purge", "--unused-days", "30", "--yes"});
    EXPECT_EQ(held.exitCode, 0) << held.err;
    EXPECT_NE(held.err.find("warning: The clock of this machine is so far ahead"), std::string::npos)
        << held.err;
    EXPECT_EQ(held.out, "Deleted 0 studies, 0 volumes, 0 models and 0 stored states.\n");
    EXPECT_EQ(studies(), 2u);
    EXPECT_EQ(jsonOf({"audit", "--last", "1"})["entries"][0]["action"], "held");
    EXPECT_EQ(jsonOf({"purge", "--unused-days", "30", "--dry-run"})["clock"], "ahead");
    expectRefused({"purge", "--all", "--trust-clock", "--yes"}, 2, "--trust-clock");
    const json report = jsonOf({"purge", "--unused-days", "30", "--trust-clock", "--yes"});
    EXPECT_EQ(report["clock"], "none");
    EXPECT_EQ(report["studies"], 2);
    EXPECT_EQ(studies(), 0u);
}

TEST_F(SessionsPurge, OnlySaysWhatWouldGo) {
    fill();
    const json study = jsonOf({"purge", anna(), "--dry-run"});
    EXPECT_EQ(study["studies"], json::array({anna()}));
    EXPECT_EQ(study["models"], 2);
    EXPECT_EQ(study["modelBytes"], 2'000'000);
    EXPECT_EQ(study["documents"], 1);
    EXPECT_EQ(jsonOf({"purge", "--all", "--dry-run"})["models"], 3);
    EXPECT_EQ(jsonOf({"purge", "--unused-days", "30", "--dry-run"})["studies"].size(), 2u);
    EXPECT_EQ(studies(), 2u);
    EXPECT_EQ(jsonOf({"audit"})["entries"].size(), 3u);
}

// A model of a volume that another study has stays, and is not told to go.
TEST_F(SessionsPurge, CountsOnlyWhatGoes) {
    fill();
    ASSERT_TRUE(session::test::isOk(open().recordOpened(opened("4.5.6", "chest"))));
    EXPECT_EQ(jsonOf({"purge", anna(), "--dry-run"})["models"], 0);
    EXPECT_EQ(jsonOf({"purge", anna(), "--yes"})["models"], 0);
    EXPECT_EQ(jsonOf({"show", bert()})["models"].size(), 2u);
}

TEST_F(SessionsPurge, AsksAtATerminal) {
    fill();
    const Ran no = typing("n\n", {"purge", anna()});
    EXPECT_EQ(no.exitCode, 130) << no.err;
    EXPECT_NE(no.err.find("Delete 1 study, 2 models (2.0 MB) and 1 stored state (" + anna().substr(0, 12) +
                          ")? Nobody can bring them back. [y/N] "),
              std::string::npos)
        << no.err;
    EXPECT_NE(no.err.find("Nothing was deleted."), std::string::npos) << no.err;
    EXPECT_EQ(typing("\n", {"purge", anna()}).exitCode, 130) << "no answer is a no";
    EXPECT_EQ(studies(), 2u);
    const Ran yes = typing("y\n", {"purge", anna()});
    EXPECT_EQ(yes.exitCode, 0) << yes.err;
    EXPECT_EQ(studies(), 1u);
}

TEST_F(SessionsPurge, TellsOfDamagedFilesThatMayHoldParts) {
    fill();
    damageDatabase();
    EXPECT_EQ(studies(), 2u);
    const Ran ran = sessions({"purge", anna(), "--yes"});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_NE(ran.err.find("warning: 1 folder of damaged files"), std::string::npos) << ran.err;
    EXPECT_EQ(jsonOf({"purge", "--all", "--yes", "--damaged-too"})["damagedFolders"], 0);
    EXPECT_FALSE(fs::exists(at("store/damaged")));
}

TEST_F(SessionsPurge, LeavesWhatIsOpen) {
    fill();
    session::Store other = open();
    const auto mark = session::test::valueOf(other.markOpen(session::test::keyOf("chest")));
    expectRefused({"purge", anna(), "--yes"}, 2, "in use by another program");
    const Ran all = sessions({"purge", "--all", "--yes"});
    EXPECT_NE(all.err.find("warning: 1 study was left"), std::string::npos) << all.err;
    EXPECT_EQ(studies(), 1u);
}

TEST_F(SessionsPurge, HasToBeToldWhat) {
    fill();
    expectRefused({"purge", "--yes"}, 2, "not said what to delete");
    expectRefused({"purge", anna(), "--all", "--yes"}, 2, "--all");
    expectRefused({"purge", "--all", "--unused-days", "3", "--yes"}, 2, "--unused-days");
    expectRefused({"purge", "--unused-days", "0", "--yes"}, 2, "--unused-days");
    EXPECT_EQ(studies(), 2u);
}

}  // namespace
}  // namespace macula::cli
