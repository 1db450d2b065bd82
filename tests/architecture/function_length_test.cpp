// No function is longer than a person reads in one go.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include "architecture/functions.h"
#include "architecture/sources.h"
#include "base/paths.h"

namespace {

using macula::test::Function;
using macula::test::functionsOf;

constexpr int kMostLines = 80;

// "name:line+lines" of each function, or "braces do not match".
std::string found(std::string_view source) {
    bool isBalanced = false;
    std::ostringstream text;
    for (const Function& f : functionsOf(source, isBalanced))
        text << (text.tellp() > 0 ? " " : "") << f.name << ":" << f.line << "+" << f.lines;
    return isBalanced ? text.str() : "braces do not match";
}

TEST(FunctionLength, IsCountedFromDeclarationToClosingBrace) {
    EXPECT_EQ(found("int a() { return 1; }"), "a:1+1");
    EXPECT_EQ(found("\n\nint a(int b,\n      int c) {\n    return b;\n}\n"), "a:3+4");
    EXPECT_EQ(found("void a() {\n}\nvoid b() {\n\n}\n"), "a:1+2 b:3+3");
    EXPECT_EQ(found("template <class T = int>\nT a() {\n}\n"), "a:1+3");
    EXPECT_EQ(found("Result<Image> Image::create(int a) {\n}"), "Image::create:1+2");
}

TEST(FunctionLength, SeesEveryKindOfFunction) {
    EXPECT_EQ(found("A::A(int a) : a_{a}, b_(2) {\n}"), "A::A:1+2");
    EXPECT_EQ(found("A::A(int a) : b_(2), a_{a} {\n}"), "A::A:1+2");
    EXPECT_EQ(found("A::~A() {\n}"), "A::~A:1+2");
    EXPECT_EQ(found("int A::a() const noexcept {\n}"), "A::a:1+2");
    EXPECT_EQ(found("auto a(int b = {}) -> std::vector<int> {\n}"), "a:1+2");
    EXPECT_EQ(found("bool operator==(const A& a) {\n}"), "operator:1+2");
    EXPECT_EQ(found("class A {\n  public:\n    int a() {\n    }\n};"), "a:3+2");
    EXPECT_EQ(found("struct alignas(16) A {\n    int a() {\n    }\n};"), "a:2+2");
    EXPECT_EQ(found("namespace a {\nnamespace {\nvoid b() {\n}\n}\n}"), "b:3+2");
    EXPECT_EQ(found("layout(local_size_x = 8) in;\nvec3 a(inout vec3 b) {\n}"), "a:2+2");
}

TEST(FunctionLength, KnowsWhatIsNoFunction) {
    EXPECT_EQ(found("namespace a {\n}"), "");
    EXPECT_EQ(found("struct A {\n    int a = 1;\n};"), "");
    EXPECT_EQ(found("enum class A : int { b, c };"), "");
    EXPECT_EQ(found("const std::map<int, int> a{{1, 2}};"), "");
    EXPECT_EQ(found("const auto a = [](int b) {\n    return b;\n};"), "");
    EXPECT_EQ(found("struct A {\n    std::function<int(int)> a = [](int b) {\n        return b;\n    };\n};"),
              "");
    EXPECT_EQ(found("layout(set = 0, binding = 1) buffer A {\n    uint a[];\n};"), "");
    EXPECT_EQ(found("void a() {\n    const auto b = [&](int c) {\n        return c;\n    };\n}"), "a:1+5");
    EXPECT_EQ(found("void a() {\n    if (b) {\n    } else {\n    }\n}"), "a:1+5");
}

TEST(FunctionLength, OverlooksCommentsLiteralsAndDirectives) {
    EXPECT_EQ(found("// void a() {\nvoid b() {\n    // }\n}"), "b:2+3");
    EXPECT_EQ(found("/* { */ void b() { /* } */ }"), "b:1+1");
    EXPECT_EQ(found("void b() {\n    c(\"}\\\"}\", '}', '\\'');\n}"), "b:1+3");
    EXPECT_EQ(found("void b() {\n    c(R\"x(}\n)\"})x\");\n}"), "b:1+4");
    EXPECT_EQ(found("#define A(b) \\\n    void b() {\nvoid c() {\n}"), "c:3+2");
    EXPECT_EQ(found("void b() {\n    c(1'000'000);\n}"), "b:1+3");
    EXPECT_EQ(found("void b() {\n    c(U'{', u8'\"', L'}');\n}"), "b:1+3");
    EXPECT_EQ(found("void b() {"), "braces do not match");
    EXPECT_EQ(found("void b() {\n}\n}"), "braces do not match");
}

TEST(FunctionLength, IsAtMostEightyLines) {
    std::size_t count = 0;
    for (const char* folder : {"src", "shaders"}) {
        for (const auto& path : macula::test::sourcesIn(folder)) {
            const std::string file = path.lexically_relative(macula::test::projectFolder()).generic_string();
            std::ifstream text(path);
            const std::string source{std::istreambuf_iterator<char>(text), {}};
            bool isBalanced = false;
            for (const Function& f : functionsOf(source, isBalanced)) {
                ++count;
                EXPECT_LE(f.lines, kMostLines) << file << ":" << f.line << ": " << f.name << " has "
                                               << f.lines << " lines: split it into named steps";
            }
            EXPECT_TRUE(isBalanced) << file << ": the braces were not understood";
        }
    }
    EXPECT_GT(count, 1000u) << "the sources were not found";
}

}  // namespace
