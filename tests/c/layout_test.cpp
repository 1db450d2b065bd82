// Structs of macula.h do not change: programs that were built against them go on.
#include "c/layout.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "base/paths.h"
#include "c/header_text.h"

namespace macula::test {
namespace {

using Layout = std::map<std::string, std::string>;  // "macula_error.message" to "8 bytes at 8"

std::string textOf(std::size_t size, std::size_t offset) {
    return std::to_string(size) + " bytes at " + std::to_string(offset);
}

Layout layoutNow() {
    Layout layout;
    for (const place* at = kLayout; at->name != nullptr; ++at)
        layout[at->name] = textOf(at->size, at->offset);
    return layout;
}

// Lines of layout.txt: name, size, offset.
Layout layoutPromised() {
    std::ifstream text(projectFolder() / "tests/c/layout.txt");
    Layout layout;
    std::string name;
    for (std::size_t size = 0, offset = 0; text >> name >> size >> offset;)
        layout[name] = textOf(size, offset);
    return layout;
}

TEST(CLayout, IsThatOfTheList) {
    const Layout now = layoutNow();
    const Layout promised = layoutPromised();
    ASSERT_GT(promised.size(), 50u) << "tests/c/layout.txt was not found";
    for (const auto& [name, place] : promised) {
        const auto found = now.find(name);
        if (found == now.end())
            ADD_FAILURE() << name << " is gone: hosts that use it break";
        else
            EXPECT_EQ(found->second, place) << name << " has moved: hosts that were built before break";
    }
    for (const auto& [name, place] : now)
        EXPECT_TRUE(promised.contains(name))
            << name << ", " << place << ", is new: add it to tests/c/layout.txt";
}

// A struct or member that layout.c does not know would be tested by nobody.
TEST(CLayout, KnowsEveryMemberOfTheHeader) {
    std::istringstream header(headerText());
    const Layout now = layoutNow();
    std::string structName;
    std::size_t members = 0;
    for (std::string line; std::getline(header, line);) {
        line = line.substr(0, line.find("/*"));
        if (line.find_first_not_of(' ') == line.find('*')) continue;  // within a comment, or empty
        if (line.starts_with("typedef struct ") && line.ends_with("{")) {
            structName = line.substr(15, line.find(' ', 15) - 15);
            EXPECT_TRUE(now.contains(structName)) << structName;
        } else if (line.starts_with("}")) {
            structName.clear();
        } else if (!structName.empty() && line.find(';') != std::string::npos) {
            std::string member = line.substr(0, line.find(';'));
            member = member.substr(0, member.find('['));
            member = member.substr(member.find_last_of(' ') + 1);
            EXPECT_TRUE(now.contains(structName + "." + member)) << structName << "." << member;
            ++members;
        }
    }
    EXPECT_GT(members, 50u) << "the header was not found";
}

// Each struct begins with its size: it is how an older one is told from a newer.
TEST(CLayout, BeginsWithTheSize) {
    std::size_t structs = 0;
    for (const auto& [name, place] : layoutNow()) {
        if (name.find('.') != std::string::npos) continue;
        ++structs;
        EXPECT_EQ(layoutNow().at(name + ".size"), textOf(4, 0)) << name;
    }
    EXPECT_GE(structs, 8u);
}

}  // namespace
}  // namespace macula::test
