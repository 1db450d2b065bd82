// Stopped or killed at any moment: what was there is there, or the new one, whole.
#include <fmt/format.h>

#include <csignal>
#include <filesystem>
#include <map>

#include "cli/run_command.h"

namespace macula::cli {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using std::chrono::microseconds;

constexpr int kMoments = 20;

class Signals : public CommandTest {
  protected:
    std::map<std::string, std::string> contents(bool withDrafts = true) const {
        std::map<std::string, std::string> all;
        for (const auto& entry : fs::recursive_directory_iterator(at("out"))) {
            const std::string name = fs::relative(entry.path(), at("out")).string();
            const bool isDraft = name.starts_with(".");
            if (entry.is_regular_file() && (withDrafts || !isDraft)) all[name] = readAll(entry.path());
        }
        return all;
    }
    // `arguments` write into the folder "out", the same each time, over a file that is there.
    void expectAllOrNothing(const std::vector<std::string>& arguments, const std::vector<std::string>& files,
                            bool eachSignalAtEachMoment = true) {
        const auto reset = [&] {
            fs::remove_all(at("out"));
            fs::create_directory(at("out"));
            for (const std::string& file : files) write("out/" + file, "a good one");
        };
        reset();
        const auto before = contents();
        const auto start = Clock::now();
        const Ran whole = runMacula(arguments);
        const auto took = Clock::now() - start;
        ASSERT_EQ(whole.exitCode, 0) << whole.err;
        const auto after = contents();
        ASSERT_NE(after, before);
        constexpr int kSignals[] = {SIGINT, SIGTERM, SIGKILL};
        for (int moment = 0; moment < kMoments; ++moment) {
            for (std::size_t i = 0; i < std::size(kSignals); ++i) {
                if (!eachSignalAtEachMoment && std::size_t(moment) % std::size(kSignals) != i) continue;
                const int signal = kSignals[i];
                reset();
                const auto when =
                    std::chrono::duration_cast<microseconds>(took * (2 * moment + 1) / (2 * kMoments));
                const Ran ran = runMaculaSignalled(arguments, signal, when);
                const std::string what =
                    fmt::format("{} {}, signal {} after {} us, exit code {}: {}", arguments[0], arguments[1],
                                signal, when.count(), ran.exitCode, ran.err);
                if (signal == SIGKILL) {
                    const auto left = contents(false);
                    EXPECT_TRUE(left == before || left == after) << what;
                    continue;
                }
                if (ran.exitCode == 0) {
                    EXPECT_EQ(contents(), after) << what;  // it was done already
                    continue;
                }
                // The system's own end, before the program began.
                if (ran.exitCode != 128 + signal) {
                    EXPECT_EQ(ran.exitCode, 130) << what;
                }
                EXPECT_EQ(contents(), before) << what;
            }
        }
    }
};

TEST_F(Signals, Render) {
    expectAllOrNothing({"render", "-o", at("out/a.png"), "--size", "64x64", "--spp", "8", "--overwrite"},
                       {"a.png"});
}

TEST_F(Signals, RenderUntilConverged) {
    expectAllOrNothing({"render", "-o", at("out/a.png"), "--size", "32x32", "--error", "0.05", "--overwrite"},
                       {"a.png"});
}

TEST_F(Signals, Export) {
    expectAllOrNothing({"export", "phantom:", "-o", at("out/a.nii.gz"), "--overwrite"}, {"a.nii.gz"});
    expectAllOrNothing({"export", "phantom:", "-o", at("out/a.mha"), "--overwrite"}, {"a.mha"});
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
    expectAllOrNothing({"sheet", "-o", at("out/a.png"), "--tile", "16", "--spp", "1", "--overwrite"},
                       {"a.png"}, false);
}

TEST_F(Signals, AConvergingPictureIsKeptOnlyWhenAskedFor) {
    const auto isAtWork = [](const std::string& err) {
        return err.find("Tracing until") != std::string::npos;
    };
    write("a.png", "a good one");
    const std::vector<std::string> endless{"render",  "-o",     at("a.png"), "--size",     "64x64",
                                           "--error", "0.0001", "--denoise", "--overwrite"};
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
