// What one verb tells of a study and its preset, every verb that draws tells.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "cli/run_command.h"

namespace macula::cli {
namespace {

constexpr std::string_view kOtherUnits = "The preset is made for other units than those of the series.";
constexpr std::string_view kStretched = "The preset was stretched to this volume";

// Without the name of the program that tells them.
std::vector<std::string> notesOf(const Ran& ran) {
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    std::vector<std::string> notes;
    std::istringstream lines(ran.err);
    for (std::string line; std::getline(lines, line);) {
        for (const std::string_view program : {"macula: ", "macula-bench: "}) {
            if (!line.starts_with(program)) continue;
            const std::string told = line.substr(program.size());
            if (told.starts_with("note: ") || told.starts_with("warning: ")) notes.push_back(told);
        }
    }
    return notes;
}
bool tells(const std::vector<std::string>& notes, std::string_view what) {
    return std::any_of(notes.begin(), notes.end(),
                       [&](const std::string& note) { return note.find(what) != std::string::npos; });
}

class Notes : public CommandTest {
  protected:
    // A cube of eight voxels a side whose values have no unit, as those of MR.
    std::string unitless() const {
        std::string text =
            "NRRD0004\ntype: uint16\ndimension: 3\nspace: left-posterior-superior\nsizes: 8 8 8\n"
            "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\nencoding: raw\nendian: "
            "little\n\n";
        for (int i = 0; i < 512; ++i) text += {static_cast<char>(i & 0xff), static_cast<char>(i >> 8)};
        return write("unitless.nrrd", text);
    }
    std::vector<std::string> ofRender(const std::vector<std::string>& more) const {
        // From a side that is chosen: of the usual one there would be a note of its own.
        std::vector<std::string> words{"render", unitless(), "-o",          at("a.png"), "--size",  "16x16",
                                       "--spp",  "1",        "--overwrite", "--view",    "anterior"};
        words.insert(words.end(), more.begin(), more.end());
        return notesOf(runMacula(words));
    }
};

TEST_F(Notes, OfBenchAreThoseOfRender) {
    const std::vector<std::string> common{"--size", "16", "--repetitions", "1"};
    for (const std::vector<std::string>& preset :
         {std::vector<std::string>{}, std::vector<std::string>{"--preset", "ct-bone"}}) {
        const std::vector<std::string> notes = ofRender(preset);
        EXPECT_TRUE(tells(notes, preset.empty() ? kStretched : kOtherUnits));
        // Look before you rely on it; and what would be better.
        EXPECT_EQ(tells(notes, "warning: " + std::string(kOtherUnits) + " Presets for it: cinematic-mr, "),
                  !preset.empty());
        for (const std::vector<std::string>& bench :
             {std::vector<std::string>{"foveal", unitless(), "--converged-spp", "0"},
              std::vector<std::string>{"trace", unitless(), "--spp", "1", "--lights", "even"}}) {
            std::vector<std::string> words = bench;
            words.insert(words.end(), common.begin(), common.end());
            words.insert(words.end(), preset.begin(), preset.end());
            const Ran ran = runBench(words);
            EXPECT_EQ(notesOf(ran), notes) << bench[0];
            const auto report = nlohmann::json::parse(ran.out);
            EXPECT_EQ(report["lights"], bench[0] == "trace" ? "even" : "studio");
            EXPECT_EQ(report["preset"], preset.empty() ? "cinematic-mr" : "ct-bone");
        }
    }
}

TEST_F(Notes, OfASheetStandBelowThePreset) {
    const Ran ran = runMacula({"sheet", unitless(), "-o", at("s.png"), "--tile", "16", "--spp", "1"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    std::istringstream lines(ran.out);
    std::string preset;
    std::size_t made = 0;
    std::set<std::string> stretched;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("panel")) preset = line.substr(line.rfind(' ') + 1);
        if (line.find(kStretched) != std::string::npos) stretched.insert(preset);
        if (line.find(kOtherUnits) == std::string::npos) continue;
        EXPECT_TRUE(preset.starts_with("ct-") || preset.starts_with("cinematic-") || preset == "uct-skull")
            << preset;
        ++made;
    }
    EXPECT_EQ(stretched, (std::set<std::string>{"cinematic-micro-ct", "cinematic-mr", "cinematic-mr-brain",
                                                "cinematic-mr-knee", "cinematic-mr-skin",
                                                "cinematic-mr-vessels", "cinematic-pet"}));
    EXPECT_GT(made, 20u);
}

TEST_F(Notes, SayThatALookIsNeverDenoised) {
    const std::string_view said = "--denoise does nothing";
    EXPECT_TRUE(tells(ofRender({"--look", "mip", "--denoise"}), said));
    EXPECT_FALSE(tells(ofRender({"--look", "mip"}), said));
    EXPECT_FALSE(tells(ofRender({"--denoise"}), said));
}

}  // namespace
}  // namespace macula::cli
