// docs/risk.md names the tests that show its controls: they exist.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

#include "base/paths.h"

namespace macula::test {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

std::string textOf(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

void addMatches(Names& names, const std::string& text, const std::regex& expression) {
    for (auto it = std::sregex_iterator(text.begin(), text.end(), expression); it != std::sregex_iterator();
         ++it)
        names.insert((*it)[1].str() + "." + (*it)[2].str());
}

// "Suite.Test" of every TEST, TEST_F and TEST_P.
Names allTests() {
    static const std::regex kTest(R"(TEST(?:_[FP])?\(\s*(\w+),\s*(\w+)\s*\))");
    Names names;
    for (const auto& entry : fs::recursive_directory_iterator(projectFolder() / "tests")) {
        if (entry.path().extension() != ".cpp") continue;
        const std::string text = textOf(entry.path());
        std::smatch match;
        for (std::size_t at = text.find("TEST"); at != std::string::npos; at = text.find("TEST", at + 1)) {
            if (std::regex_search(text.begin() + std::ptrdiff_t(at), text.end(), match, kTest,
                                  std::regex_constants::match_continuous))
                names.insert(match[1].str() + "." + match[2].str());
        }
    }
    return names;
}

TEST(Risk, EveryTestThatItNamesExists) {
    static const std::regex kNamed(R"(`([A-Z]\w*)\.(\w+)`)");
    Names named;
    addMatches(named, textOf(projectFolder() / "docs/risk.md"), kNamed);
    EXPECT_GE(named.size(), 30u) << "docs/risk.md was not found";
    const Names tests = allTests();
    ASSERT_GT(tests.size(), 1000u);
    for (const std::string& name : named)
        EXPECT_TRUE(tests.contains(name)) << name << " shows nothing: it is gone";
}

// Each hazard has a severity, a probability, a control and a test.
TEST(Risk, EveryHazardIsRatedAndHasAControlAndATest) {
    std::ifstream page(projectFolder() / "docs/risk.md");
    std::size_t hazards = 0;
    for (std::string line; std::getline(page, line);) {
        if (!line.starts_with("| ") || line.starts_with("| hazard") || line.starts_with("|---")) continue;
        ++hazards;
        static const std::regex kRow(
            R"(\| [^|]+ \| [^|]+ \| (minor|serious|critical) \| (improbable|remote|occasional) )"
            R"(\| [^|]{40,} \| `\w+\.\w+`[^|]* \|)");
        EXPECT_TRUE(std::regex_match(line, kRow)) << line;
    }
    EXPECT_GE(hazards, 7u);
}

}  // namespace
}  // namespace macula::test
