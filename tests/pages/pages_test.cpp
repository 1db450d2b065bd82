// The pages tell the truth where a machine can tell: links, paths and command lines.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "base/paths.h"
#include "pages/commands.h"
#include "pages/page.h"
#include "pipeline/trace/look.h"

namespace macula::test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> pagesIn(const fs::path& folder) {
    std::vector<fs::path> pages;
    for (const auto& entry : fs::directory_iterator(projectFolder() / folder))
        if (entry.path().extension() == ".md")
            pages.push_back((folder / entry.path().filename()).lexically_normal());
    std::sort(pages.begin(), pages.end());
    return pages;
}

Page readFile(const fs::path& file) {
    std::ifstream stream(projectFolder() / file);
    return readPage(std::string{std::istreambuf_iterator<char>(stream), {}});
}

// Of a page at docs/page.md.
std::vector<std::string> broken(std::string_view markdown) {
    return brokenReferences(readPage(markdown), projectFolder(), "docs/page.md");
}

std::string refused(std::string_view line, bool isWhole = true) {
    return whyRefused(maculaWords(line), isWhole);
}

TEST(Pages, ABrokenReferenceIsFound) {
    EXPECT_EQ(broken("[a](dicom.md) [b](../README.md) ![c](images/ct_cta_rider.png)").size(), 0u);
    EXPECT_EQ(broken("[a](no-such-page.md)").size(), 1u);
    EXPECT_EQ(broken("text\n\n![a](images/none.png)"),
              std::vector<std::string>{"docs/page.md:3: images/none.png leads to no file"});
    EXPECT_EQ(broken("# My `own` heading, here\n[a](#my-own-heading-here)").size(), 0u);
    EXPECT_EQ(broken("# My heading\n[a](#my-headings)").size(), 1u);
    EXPECT_EQ(broken("[a](window.md#no-such-heading)").size(), 1u);
    EXPECT_EQ(broken("[a](https://example.org/none) `[a](none.md)`\n\n    [a](none.md)\n").size(), 0u);
    EXPECT_EQ(broken("```\n[a](none.md)\n```\n[b](none.md)").size(), 1u);
    EXPECT_EQ(
        broken("`src/base/volume.h` `src/cli/NAME_command.cpp` `shaders/lib/splat_*.glsl` `a/b`").size(), 0u);
    EXPECT_EQ(broken("`src/base/no_such_file.h`").size(), 1u);
    EXPECT_EQ(broken("- a list\n    `src/base/no_such_file.h`, which goes on").size(), 1u);
    EXPECT_EQ(readPage("as `macula-bench\n  speed` is").codeSpans.at(0).text, "macula-bench speed");
}

TEST(Pages, ACommandThatMaculaRefusesIsFound) {
    for (const char* good :
         {"macula info FOLDER [--json] [--patient]   # of whom",
          "build/dev/bin/macula render FOLDER -o a.png --preset CT-Bone --look mip",
          "macula render FOLDER -o a.png --preset 101 --lights studio --clip left-half",
          "macula render -o a.png --preset mine.json --size 1024x768 --look NAME",
          "MACULA_DEVICE=1 xvfb-run macula-bench cast …", "macula presets", "macula presets show CT-Bone",
          "build/dev/bin/macula-bench evaluate init [PATH...] --preset NAME"})
        EXPECT_EQ(refused(good), "") << good;
    EXPECT_EQ(refused("macula draw FOLDER"), "there is no verb draw");
    EXPECT_EQ(refused("macula-bench speed"), "there is no verb speed");
    EXPECT_EQ(refused("macula-bench evaluate"), "a verb is missing");
    EXPECT_EQ(refused("macula bench trace"), "there is no verb bench");
    EXPECT_EQ(refused("macula render -o a.png --sharp"), "there is no option --sharp");
    EXPECT_EQ(refused("macula info FOLDER --spp 3"), "there is no option --spp");
    EXPECT_EQ(refused("macula render -o a.png --look xray"), "xray is no --look");
    EXPECT_EQ(refused("macula render -o a.png --preset bones"), "bones is no preset of `macula presets`");
    EXPECT_EQ(refused("macula render -o a.png --lights moon"), "moon is no lights of `macula presets`");
    EXPECT_EQ(refused("macula presets show bones"), "bones is no preset of `macula presets`");
    EXPECT_EQ(refused("macula render FOLDER"), "-o,--output is missing");
    EXPECT_EQ(refused("macula render FOLDER", false), "") << "in the middle of a sentence";
    EXPECT_TRUE(maculaWords("macula-viewer FOLDER").empty());
    EXPECT_TRUE(maculaWords("./run FOLDER").empty());
}

TEST(Pages, ANameThatNoSourceHasIsFound) {
    const Sources sources = readSources(projectFolder());
    const auto unknown = [&](std::string_view markdown) { return unknownNames(readPage(markdown), sources); };
    EXPECT_EQ(
        unknown("`PathTracer`, `gpu::Device`, `volume.h`, `trace/settings.h`, `views`, `NAME.json`").size(),
        0u);
    EXPECT_EQ(unknown("a\n`PathTraces`"), std::vector<std::string>{"2: PathTraces"});
    EXPECT_EQ(unknown("`gpu::Divice`").size(), 1u);
    EXPECT_EQ(unknown("`trace/volume.h` is in another folder").size(), 1u);
}

// Of the two pages about the code.
TEST(Pages, NamesAreInTheCode) {
    const Sources sources = readSources(projectFolder());
    for (const char* file : {"ARCHITECTURE.md", "CONTRIBUTING.md"})
        for (const std::string& name : unknownNames(readFile(file), sources))
            ADD_FAILURE() << file << ":" << name << " is in no source";
}

TEST(Pages, ReferencesLeadSomewhere) {
    std::size_t count = 0;
    for (const char* folder : {".", "docs", "docs/measurements"}) {
        for (const fs::path& file : pagesIn(folder)) {
            const Page page = readFile(file);
            count += page.links.size();
            for (const std::string& why : brokenReferences(page, projectFolder(), file)) ADD_FAILURE() << why;
        }
    }
    EXPECT_GT(count, 20u) << "the pages were not found";
}

TEST(Pages, EveryVerbIsOnItsPage) {
    std::vector<std::string> lines;
    for (const PageText& code : readFile("docs/command.md").codeLines) lines.push_back(code.text + " ");
    for (const char* group :
         {"macula", "macula pacs", "macula sessions", "macula-bench", "macula-bench evaluate"}) {
        const auto& verbs = verbsBehind(maculaWords(group));
        EXPECT_FALSE(verbs.empty()) << group;
        for (const std::string& verb : verbs) {
            const std::string call = std::string(group) + " " + verb + " ";
            EXPECT_TRUE(std::ranges::any_of(lines, [&](const auto& line) { return line.starts_with(call); }))
                << call;
        }
    }
}

TEST(Pages, EveryLookIsInItsTable) {
    std::ifstream stream(projectFolder() / "docs/presets.md");
    const std::string page{std::istreambuf_iterator<char>(stream), {}};
    for (const trace::LookTraits& look : trace::kLooks)
        EXPECT_NE(page.find("\n| `" + std::string(look.name) + "` |"), std::string::npos) << look.name;
}

// Logs of measurements are left out: they tell what was called once.
TEST(Pages, CommandsAreUnderstood) {
    std::size_t count = 0;
    for (const char* folder : {".", "docs"}) {
        for (const fs::path& file : pagesIn(folder)) {
            if (file == "CHANGELOG.md") continue;
            const Page page = readFile(file);
            for (const bool isWhole : {false, true}) {
                for (const PageText& code : isWhole ? page.codeLines : page.codeSpans) {
                    const auto words = maculaWords(code.text);
                    if (words.empty()) continue;
                    ++count;
                    EXPECT_EQ(whyRefused(words, isWhole), "")
                        << file.string() << ":" << code.line << ": " << code.text;
                }
            }
        }
    }
    EXPECT_GT(count, 40u) << "the pages were not found";
}

}  // namespace
}  // namespace macula::test
