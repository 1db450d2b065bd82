// Stopped or killed at any moment: what was there is there, or the new one, whole.
#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/run_command.h"
#include "pipeline/splat/files/model_file.h"

namespace macula::cli {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using std::chrono::microseconds;

constexpr int kMoments = 20;
constexpr int kMomentsOfQuickRuns = 5;
constexpr int kMomentsOfSlowOnes = 3;
constexpr int kSignals[] = {SIGINT, SIGTERM, SIGKILL};
using Contents = std::map<std::string, std::string>;  // by name

// With MACULA_EVERY_SIGNAL in the environment each of the signals at each of kMoments; else fewer moments,
// and at each another of them.
bool isThorough() {
    return std::getenv("MACULA_EVERY_SIGNAL") != nullptr;
}
bool isTried(int moment, std::size_t signal) {
    return isThorough() || std::size_t(moment) % std::size(kSignals) == signal;
}

class Signals : public CommandTest {
  protected:
    Contents contents(bool withDrafts = true) const {
        Contents all;
        for (const auto& entry : fs::recursive_directory_iterator(at("out"))) {
            const std::string name = fs::relative(entry.path(), at("out")).string();
            const bool isDraft = name.starts_with(".");
            if (entry.is_regular_file() && (withDrafts || !isDraft)) all[name] = readAll(entry.path());
        }
        return all;
    }

    // `arguments` write into the folder "out", over `files` that are there. Whatever comes, what is there
    // then `isWhole`; when told to stop, the command says so and leaves no drafts. Without `isWhole` it is
    // what was there before, unless the command was done or killed: then it may be what a run without a
    // signal makes.
    void expectAllOrNothing(const std::vector<std::string>& arguments, const std::vector<std::string>& files,
                            std::function<bool(const Contents&)> isWhole = {},
                            int moments = kMomentsOfQuickRuns,
                            TestedProgram program = TestedProgram::macula) {
        if (isThorough()) moments = kMoments;
        const auto reset = [&] {
            fs::remove_all(at("out"));
            fs::create_directory(at("out"));
            for (const std::string& file : files) write("out/" + file, kGood);
        };
        reset();
        const Contents before = contents();
        const auto start = Clock::now();
        const Ran whole = run(program, arguments);
        const auto took = Clock::now() - start;
        ASSERT_EQ(whole.exitCode, 0) << whole.err;
        const Contents after = contents();
        ASSERT_NE(after, before);
        if (isWhole) {
            ASSERT_TRUE(isWhole(after));
        }
        for (int moment = 0; moment < moments; ++moment) {
            for (std::size_t i = 0; i < std::size(kSignals); ++i) {
                if (!isTried(moment, i)) continue;
                const int signal = kSignals[i];
                reset();
                const auto when =
                    std::chrono::duration_cast<microseconds>(took * (2 * moment + 1) / (2 * moments));
                const Ran ran = runSignalled(program, arguments, signal, when);
                const std::string what =
                    fmt::format("{} {}, signal {} after {} us, exit code {}: {}", arguments[0], arguments[1],
                                signal, when.count(), ran.exitCode, ran.err);
                const bool isDone = ran.exitCode == 0;
                // Or the system's own end, before the program began.
                if (signal != SIGKILL && !isDone && ran.exitCode != 128 + signal) {
                    EXPECT_EQ(ran.exitCode, 130) << what;
                }
                const Contents left = contents(signal != SIGKILL);
                if (isWhole) {
                    EXPECT_TRUE(isWhole(left)) << what;
                } else if (signal == SIGKILL) {
                    EXPECT_TRUE(left == before || left == after) << what;
                } else {
                    EXPECT_EQ(left, isDone ? after : before) << what;
                }
            }
        }
    }

    static constexpr const char* kGood = "a good one";
};

TEST_F(Signals, Render) {
    expectAllOrNothing(
        {"render", writeBall(), "-o", at("out/a.png"), "--size", "64x64", "--spp", "8", "--overwrite"},
        {"a.png"});
}

TEST_F(Signals, RenderUntilConverged) {
    expectAllOrNothing(
        {"render", writeBall(), "-o", at("out/a.png"), "--size", "32x32", "--error", "0.05", "--overwrite"},
        {"a.png"});
}

TEST_F(Signals, Export) {
    expectAllOrNothing({"export", "phantom:", "-o", at("out/a.nii.gz"), "--overwrite"}, {"a.nii.gz"});
    expectAllOrNothing({"export", "phantom:", "-o", at("out/a.mha"), "--overwrite"}, {"a.mha"}, {},
                       kMomentsOfSlowOnes);
}

TEST_F(Signals, Presets) {
    expectAllOrNothing({"presets", "export", "ct-bone", "-o", at("out/a.json"), "--overwrite"}, {"a.json"});
    ASSERT_EQ(runMacula({"presets", "export", "ct-bone", "-o", at("b.json")}).exitCode, 0);
    expectAllOrNothing({"presets", "import", at("b.json"), "-o", at("out/a.json"), "--overwrite"},
                       {"a.json"});
}

TEST_F(Signals, Phantom) {
    expectAllOrNothing({"phantom", at("out/study")}, {});
}

TEST_F(Signals, Sheet) {
    expectAllOrNothing(
        {"sheet", writeBall(), "-o", at("out/a.png"), "--tile", "16", "--spp", "1", "--overwrite"}, {"a.png"},
        {}, kMomentsOfSlowOnes);
}

// What was trained until then stands beside a model that is there, under a name that says so.
TEST_F(Signals, Train) {
    const auto isModel = [this](const std::string& name) { return splat::readModel(at("out/" + name)).ok(); };
    expectAllOrNothing(
        {"train", writeBall(), "-o", at("out/a.ply"), "--overwrite", "--size", "32", "--views", "3", "--spp",
         "1", "--points", "300", "--iterations", "40", "--directions", "5"},
        {"a.ply"},
        [&](const Contents& left) {
            return std::all_of(left.begin(), left.end(), [&](const auto& file) {
                return (file.first == "a.ply" && file.second == kGood) || isModel(file.first);
            });
        },
        kMomentsOfSlowOnes);
}

TEST_F(Signals, SplatRender) {
    ASSERT_EQ(runMacula({"train", writeBall(), "-o", at("ball.ply"), "--size", "32", "--views", "3", "--spp",
                         "1", "--points", "300", "--iterations", "4", "--directions", "5"})
                  .exitCode,
              0);
    // Each picture is whole by itself.
    std::set<std::string> whole{kGood};
    fs::create_directory(at("whole"));
    const std::vector<std::string> arguments{
        "splat-render", at("ball.ply"), "--size", "64x64",       "--from",
        "anterior",     "--from",       "left",   "--overwrite", "-o"};
    std::vector<std::string> once = arguments;
    once.push_back(at("whole"));
    ASSERT_EQ(runMacula(once).exitCode, 0);
    for (const auto& entry : fs::directory_iterator(at("whole"))) whole.insert(readAll(entry.path()));
    ASSERT_EQ(whole.size(), 3u);
    std::vector<std::string> over = arguments;
    over.push_back(at("out"));
    expectAllOrNothing(over, {"anterior.png", "left.png"}, [&](const Contents& left) {
        return std::all_of(left.begin(), left.end(),
                           [&](const auto& file) { return whole.contains(file.second); });
    });
}

// Times are in them, so that no two are the same.
TEST_F(Signals, Evaluate) {
    expectAllOrNothing(
        {"evaluate",
         "init",
         writeBall(),
         "--size",
         "32",
         "--points",
         "300",
         "--point-paths",
         "8",
         "--views",
         "1",
         "--spp",
         "1",
         "--truth-views",
         "2",
         "--truth-spp",
         "16",
         "--iterations",
         "0",
         "--json",
         at("out/a.json"),
         "--overwrite"},
        {"a.json"},
        [&](const Contents& left) {
            const auto& text = left.at("a.json");
            return left.size() == 1 && (text == kGood || nlohmann::json::accept(text));
        },
        kMomentsOfSlowOnes, TestedProgram::bench);
}

TEST_F(Signals, TraceTradeoff) {
    expectAllOrNothing(
        {"trace-tradeoff", writeBall(), "--size", "8", "--converged-spp", "64", "--plot", at("out/a.svg"),
         "--overwrite"},
        {"a.svg"},
        [&](const Contents& left) {
            const auto& text = left.at("a.svg");
            return left.size() == 1 && (text == kGood || text.ends_with("</svg>\n"));
        },
        kMomentsOfSlowOnes, TestedProgram::bench);
}

TEST_F(Signals, AConvergingPictureIsKeptOnlyWhenAskedFor) {
    const auto isAtWork = [](const std::string& err) {
        return err.find("Tracing until") != std::string::npos;
    };
    write("a.png", "a good one");
    // To its end it would take a thousand times as long as until the first thousandth is told.
    const std::vector<std::string> endless{"render", writeBall(), "-o",    at("a.png"), "--size",
                                           "64x64",  "--error",   "0.002", "--denoise", "--overwrite"};
    const Ran stopped = runMaculaInterrupted(endless, isAtWork);
    EXPECT_EQ(stopped.exitCode, 130) << stopped.err;
    EXPECT_NE(stopped.err.find("nothing was written"), std::string::npos) << stopped.err;
    EXPECT_EQ(readAll(at("a.png")), "a good one");

    std::vector<std::string> keeping = endless;
    keeping.emplace_back("--keep-unfinished");
    const auto hasBegun = [](const std::string& err) {
        const std::size_t at = err.find("Tracing until");
        return at != std::string::npos && err.find("Tracing until", at + 1) != std::string::npos;
    };
    const Ran kept = runMaculaInterrupted(keeping, hasBegun);
    EXPECT_EQ(kept.exitCode, 130) << kept.err;
    EXPECT_NE(kept.err.find("as it was then"), std::string::npos) << kept.err;
    EXPECT_TRUE(readAll(at("a.png")).starts_with("\x89PNG"));
}

TEST_F(Signals, WhatAKilledOneLeftIsRemovedByTheNext) {
    write(".a.0123456789abcdef.part.png", "half a picture");
    fs::create_directory(at(".b.0123456789abcdef.part"));
    write(".b.0123456789abcdef.part/b.raw", "half a volume");
    write(".a.partial.png", "somebody's own");
    ASSERT_EQ(runMacula({"presets", "export", "ct-bone", "-o", at("c.json")}).exitCode, 0);
    EXPECT_FALSE(fs::exists(at(".a.0123456789abcdef.part.png")));
    EXPECT_FALSE(fs::exists(at(".b.0123456789abcdef.part")));
    EXPECT_TRUE(fs::exists(at(".a.partial.png")));
}

}  // namespace
}  // namespace macula::cli
