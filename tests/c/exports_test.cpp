// What the library exports, what its list of symbols says, and what macula.h declares are the same.
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "base/paths.h"
#include "c/header_text.h"

namespace macula::test {
namespace {

using Names = std::set<std::string>;

std::string readText(const char* file) {
    std::ifstream stream(projectFolder() / file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

Names matchesIn(const std::string& text, const char* pattern) {
    const std::regex expression(pattern);
    Names names;
    for (auto it = std::sregex_iterator(text.begin(), text.end(), expression); it != std::sregex_iterator();
         ++it)
        names.insert((*it)[1].str());
    return names;
}

// By nm, without the versions of symbols; "MACULA_0" is that version itself.
Names exported() {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> nm(
        popen(MACULA_NM " -D --defined-only '" MACULA_LIBRARY_FILE "'", "r"), pclose);
    if (!nm) return {};
    std::string text;
    char part[4096];
    for (std::size_t read = 0; (read = std::fread(part, 1, sizeof part, nm.get())) > 0;)
        text.append(part, read);
    Names names;
    std::istringstream lines(text);
    for (std::string address, kind, name; lines >> address >> kind >> name;) {
        name = name.substr(0, name.find('@'));
        if (kind != "A") names.insert(name);
    }
    return names;
}

// A header that macula.h forgot would be looked at by these tests, and by no host.
TEST(CExports, MaculaIncludesEveryHeader) {
    const Names included =
        matchesIn(readText("src/c/include/macula.h"), R"line(#include "(macula/\w+\.h)")line");
    Names there;
    for (const auto& header : headers()) there.insert("macula/" + header.filename().string());
    EXPECT_GE(there.size(), 10u);
    EXPECT_EQ(included, there);
}

// The promise: what was in here before must stay.
TEST(CExports, AreThoseOfTheList) {
    const Names listed = matchesIn(readText("src/c/macula.map"), R"(\n\s+(macula_\w+);)");
    EXPECT_GE(listed.size(), 30u);
    EXPECT_EQ(exported(), listed);
}

TEST(CExports, AreWhatTheHeaderDeclares) {
    const Names declared = matchesIn(headerText(), R"(MACULA_API [\w ]+\*? ?(macula_\w+)\()");
    EXPECT_GE(declared.size(), 30u);
    EXPECT_EQ(exported(), declared);
}

}  // namespace
}  // namespace macula::test
