// A store with two studies and a file of none, for `macula sessions`.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "cli/run_command.h"
#include "session/store.h"
#include "session/support.h"

namespace macula::cli {

class SessionsTest : public CommandTest {
  protected:
    static constexpr std::int64_t kOpenedMs = 1'700'000'000'000;  // 2023-11-14T22:13:20Z
    static constexpr std::int64_t kDayMs = 86'400'000;

    std::string store() const { return at("store"); }
    static std::string anna() { return session::studyIdentity("1.2.3"); }
    static std::string bert() { return session::studyIdentity("4.5.6"); }

    session::Store open(std::int64_t nowMs = kOpenedMs) const {
        return session::test::valueOf(
            session::Store::open({.folder = store(), .nowMs = [nowMs] { return nowMs; }}));
    }
    static session::OpenedVolume opened(const std::string& uid, const std::string& volume) {
        return {.study = session::studyIdentity(uid),
                .series = session::seriesIdentity(uid, "1"),
                .volume = session::test::digestOf(volume)};
    }
    // Anna with two models and a stored state, then a file without a study with a model; a day later Bert.
    void fill() const {
        using namespace session::test;
        session::Store first = open();
        session::OpenedVolume ofAnna = opened("1.2.3", "chest");
        ofAnna.readableStudy = "CT Abdomen";
        ASSERT_TRUE(isOk(first.recordOpened(ofAnna)));
        ASSERT_TRUE(isOk(first.saveModel(keyOf("chest"), blobOf(1, 1'400'000))));
        ASSERT_TRUE(isOk(first.saveModel(keyOf("chest", "lung"), blobOf(2, 600'000))));
        ASSERT_TRUE(
            isOk(first.putDocument({session::DocumentKind::studyState, anna(), "last"}, 1, "{}", {})));
        ASSERT_TRUE(isOk(first.recordOpened({.volume = digestOf("nifti")})));
        ASSERT_TRUE(isOk(first.saveModel(keyOf("nifti"), blobOf(3, 1000))));
        session::Store later = open(kOpenedMs + kDayMs);
        session::OpenedVolume ofBert = opened("4.5.6", "head");
        ofBert.readableStudy = "MR\x1b[2J Head";
        ASSERT_TRUE(isOk(later.recordOpened(ofBert)));
    }

    Ran sessions(std::vector<std::string> words, const std::vector<std::string>& environment = {}) const {
        words.insert(words.begin(), "sessions");
        words.insert(words.end(), {"--folder", store()});
        return runMacula(words, environment);
    }
    // Of a call that is done.
    nlohmann::json jsonOf(std::vector<std::string> words) const {
        words.emplace_back("--json");
        const Ran ran = sessions(std::move(words));
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        return parsed(ran.out);
    }
    static nlohmann::json parsed(const std::string& text) {
        nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
        EXPECT_FALSE(json.is_discarded()) << text;
        return json;
    }
    void expectRefused(const std::vector<std::string>& words, int exitCode, const std::string& saying) const {
        const Ran ran = sessions(words);
        EXPECT_EQ(ran.exitCode, exitCode) << ran.err;
        EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
        EXPECT_NE(ran.err.find(saying), std::string::npos) << ran.err;
    }

    // What a disk does.
    void damageDatabase() const {
        const std::string text = readAll(at("store/sessions.db"));
        write("store/sessions.db", "no database" + text.substr(11));
    }
};

}  // namespace macula::cli
