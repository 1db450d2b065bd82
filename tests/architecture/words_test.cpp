// Code uses the words of docs/glossary.md: none of those that its last table rules out.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include "architecture/sources.h"
#include "base/paths.h"

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kHeading = "## Words that code does not use";

// In lower case and without underscores, so that one word rules out types, functions, variables and files.
std::string plain(std::string_view name) {
    std::string letters;
    for (const char c : name)
        if (c != '_') letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return letters;
}

// What stands in backquotes in the first column of the table.
std::vector<std::string> wordsRuledOut() {
    std::ifstream page(macula::test::projectFolder() / "docs/glossary.md");
    std::vector<std::string> words;
    bool isInTable = false;
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with("## ")) isInTable = line == kHeading;
        if (!isInTable || !line.starts_with("| `")) continue;
        const std::string column = line.substr(1, line.find('|', 1) - 1);
        for (std::size_t from = column.find('`'); from != std::string::npos;) {
            const std::size_t to = column.find('`', from + 1);
            words.push_back(plain(column.substr(from + 1, to - from - 1)));
            from = column.find('`', to + 1);
        }
    }
    return words;
}

// The names in a line of code, without those in its comment and its texts.
std::vector<std::string> namesIn(std::string_view line) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < line.size();) {
        if (line.substr(i).starts_with("//")) break;
        if (line[i] == '"') {
            for (++i; i < line.size() && line[i] != '"'; ++i)
                if (line[i] == '\\') ++i;
            ++i;
            continue;
        }
        std::size_t end = i;
        while (end < line.size() &&
               (std::isalnum(static_cast<unsigned char>(line[end])) != 0 || line[end] == '_'))
            ++end;
        if (end > i) names.emplace_back(line.substr(i, end - i));
        i = std::max(end, i + 1);
    }
    return names;
}

TEST(Words, NamesAreFoundInCodeAlone) {
    EXPECT_EQ(namesIn("int old_name = f(\"a \\\" wish\", b);  // a wish"),
              (std::vector<std::string>{"int", "old_name", "f", "b"}));
    EXPECT_EQ(plain("aRenderWish_"), "arenderwish");
}

TEST(Words, OfTheGlossaryAreThoseOfTheCode) {
    const std::vector<std::string> words = wordsRuledOut();
    ASSERT_GT(words.size(), 10u) << "the table was not found";
    for (const char* folder : {"src", "shaders", "tests"}) {
        for (const fs::path& path : macula::test::sourcesIn(folder)) {
            const fs::path shown = path.lexically_relative(macula::test::projectFolder());
            std::ifstream text(path);
            int number = 0;
            const auto check = [&](const std::string& name) {
                for (const std::string& word : words)
                    EXPECT_EQ(plain(name).find(word), std::string::npos)
                        << shown << ":" << number << ": " << name << " (docs/glossary.md)";
            };
            check(path.stem().string());
            for (std::string line; std::getline(text, line);) {
                ++number;
                for (const std::string& name : namesIn(line)) check(name);
            }
        }
    }
}

TEST(Words, NamesOfTestsBeginWithACapital) {
    const std::regex small("\\bTEST(_F|_P)?\\(\\s*(\\w+),\\s*([a-z]\\w*)\\s*\\)");
    EXPECT_TRUE(std::regex_search(std::string("TEST_F(Scan, ") + "isRead) {", small));
    for (const fs::path& path : macula::test::sourcesIn("tests")) {
        std::ifstream text(path);
        for (std::string line; std::getline(text, line);)
            EXPECT_FALSE(std::regex_search(line, small)) << path << ": " << line;
    }
}

}  // namespace
