// No class is longer than a person keeps in mind: what its header says, and all that its methods do.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>

#include "architecture/functions.h"
#include "architecture/sources.h"
#include "base/paths.h"

namespace {

namespace fs = std::filesystem;

using macula::test::Class;
using macula::test::Function;

constexpr int kMostLines = 400;
// The window lists all features.
const std::map<std::string, int> kMore{{"viewer MainWindow", 500}};

std::string contentOf(const fs::path& path) {
    std::ifstream text(path);
    return {std::istreambuf_iterator<char>(text), {}};
}

// "A" of A::f and of N::A::f; nothing of a function of no class.
std::string classOf(const std::string& function) {
    const std::size_t end = function.rfind("::");
    if (end == std::string::npos) return {};
    const std::size_t before = function.rfind("::", end - 1);
    return function.substr(before == std::string::npos ? 0 : before + 2,
                           end - (before == std::string::npos ? 0 : before + 2));
}

// Lines of each class by its folder and name, or by its file and name if a source has it for itself alone.
class Lengths {
  public:
    void addClasses(const fs::path& path, const std::string& place, const std::string& source) {
        for (const Class& each : macula::test::classesOf(source)) {
            if (path.extension() == ".cpp") ofSource_.insert(path.string() + " " + each.name);
            lines_[keyOf(path, place, each.name)] += each.lines;
        }
    }
    void addMethods(const fs::path& path, const std::string& place, const std::string& source) {
        bool isBalanced = false;
        for (const Function& each : macula::test::functionsOf(source, isBalanced))
            if (const std::string name = classOf(each.name); !name.empty())
                lines_[keyOf(path, place, name)] += each.lines;
    }
    const std::map<std::string, int>& lines() const { return lines_; }

  private:
    std::string keyOf(const fs::path& path, const std::string& place, const std::string& name) const {
        const std::string own = path.string() + " " + name;
        return ofSource_.contains(own) ? own : place + " " + name;
    }
    std::set<std::string> ofSource_;
    std::map<std::string, int> lines_;
};

TEST(ClassLength, CountsItsHeaderAndItsMethods) {
    Lengths lengths;
    const std::string header =
        "class A {\n    int a() {\n    }\n    int b();\n};\nstruct B;\nnamespace c {\n}\n";
    const std::string source = "namespace {\nstruct A {\n};\n}\n";
    lengths.addClasses("a.h", "room", header);
    lengths.addClasses("other.cpp", "room", source);
    lengths.addMethods("a.cpp", "room", "int A::b() {\n}\nint N::A::c() {\n}\nint d() {\n}\n");
    lengths.addMethods("other.cpp", "room", source);
    EXPECT_EQ(lengths.lines(), (std::map<std::string, int>{{"other.cpp A", 2}, {"room A", 5 + 2 + 2}}));
}

TEST(ClassLength, IsAtMostFourHundredLines) {
    Lengths lengths;
    const fs::path all = macula::test::projectFolder() / "src";
    const auto sources = macula::test::sourcesIn("src");
    const auto placeOf = [&](const fs::path& path) { return path.lexically_relative(all).begin()->string(); };
    for (const fs::path& path : sources) lengths.addClasses(path, placeOf(path), contentOf(path));
    for (const fs::path& path : sources) lengths.addMethods(path, placeOf(path), contentOf(path));
    for (const auto& [name, lines] : lengths.lines()) {
        const auto more = kMore.find(name);
        EXPECT_LE(lines, more == kMore.end() ? kMostLines : more->second)
            << name << ": give one of its duties a class of its own";
    }
    EXPECT_GT(lengths.lines().size(), 500u) << "the sources were not found";
}

}  // namespace
