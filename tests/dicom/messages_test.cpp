// The catalogue of coded messages, and its documentation.
#include "dicom/messages/messages.h"
#include "base/paths.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace macula::dicom {
namespace {

std::string read(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

TEST(Messages, KeysAreUniqueAndPlain) {
    std::set<std::string_view> keys;
    for (const CatalogueEntry& entry : catalogue()) {
        EXPECT_TRUE(keys.insert(entry.key).second) << entry.key;
        EXPECT_EQ(entry.key.find_first_not_of("abcdefghijklmnopqrstuvwxyz-3d"), std::string_view::npos);
        EXPECT_TRUE(entry.sentence.ends_with('.')) << entry.key;
        // Who cannot go on has to be told what to do.
        EXPECT_TRUE(entry.severity < Severity::warning || !entry.action.empty()) << entry.key;
    }
}

TEST(Messages, TheFifteenMeaningsOfOhifAreThere) {
    std::set<int> numbers;
    for (const CatalogueEntry& entry : catalogue()) {
        if (entry.ohif != 0) numbers.insert(entry.ohif);
    }
    EXPECT_EQ(numbers.size(), 15u);
    EXPECT_EQ(*numbers.begin(), 1);
    EXPECT_EQ(*numbers.rbegin(), 15);
}

TEST(Messages, ArgumentsAreTypedAndInTheSentence) {
    const Message missing = message(
        key::kMissingSlices, {{"missing", std::int64_t{2}}, {"total", std::int64_t{35}}, {"spacingMm", 4.8}});
    EXPECT_EQ(missing.sentence, "Slices that are missing: 2 of 35, which are 4.800 mm apart.");
    EXPECT_EQ(missing.severity, Severity::warning);
    EXPECT_EQ(std::get<std::int64_t>(missing.arguments[0].value), 2);
    EXPECT_EQ(std::get<double>(missing.arguments[2].value), 4.8);
}

// Every message can come: a key that nothing gives out would promise what is not there.
TEST(Messages, EachIsGivenOutSomewhere) {
    const std::filesystem::path folder = macula::test::projectFolder() / "src/dicom";
    const std::string header = read(folder / "messages/messages.h");
    std::string sources = read(folder / "rules/split.json");
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const auto file = entry.path().filename();
        if (file != "messages.cpp" && file != "messages.h" && entry.is_regular_file())
            sources += read(entry.path());
    }
    for (const CatalogueEntry& entry : catalogue()) {
        const std::string end = fmt::format(" = \"{}\";", entry.key);
        const std::size_t at = header.find(end);
        ASSERT_NE(at, std::string::npos) << entry.key;
        const std::size_t begin = header.rfind(' ', at - 1) + 1;
        const std::string constant = header.substr(begin, at - begin);
        const bool used = sources.find("key::" + constant) != std::string::npos ||
                          sources.find(fmt::format("\"{}\"", entry.key)) != std::string::npos;
        EXPECT_TRUE(used) << entry.key;
    }
}

// docs/dicom.md lists each message as it is.
TEST(Messages, AreDocumented) {
    const std::string page = read(macula::test::projectFolder() / "docs/dicom.md");
    std::string expected;
    for (const CatalogueEntry& entry : catalogue()) {
        const std::string line =
            fmt::format("| `{}` | {} | {} | {}{}{} |\n", entry.key, nameOf(entry.severity),
                        entry.ohif == 0 ? std::string() : std::to_string(entry.ohif), entry.sentence,
                        entry.action.empty() ? "" : " ", entry.action);
        EXPECT_NE(page.find(line), std::string::npos) << "missing in docs/dicom.md:\n" << line;
        expected += line;
    }
    EXPECT_NE(page.find(expected), std::string::npos) << "the table should be:\n" << expected;
}

}  // namespace
}  // namespace macula::dicom
