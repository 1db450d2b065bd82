// Finds the functions and classes of a source in C++ or GLSL, and how long each is. It matches braces, and
// knows no more of the language than that needs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace macula::test {

struct Function {
    std::string name;  // with what qualifies it: Image::create
    int line = 0;      // of the first word of its declaration
    int lines = 0;     // from there to its closing brace
};

// Those that have a body, in order. A lambda belongs to the function that it stands in, and is none at the
// level of a namespace or class; neither is what a preprocessor's directive defines. `isBalanced` becomes
// false where braces do not match, so that nothing can be said.
std::vector<Function> functionsOf(std::string_view source, bool& isBalanced);

// The classes and structs that are defined at the level of a namespace or class, in order of their closing
// braces. Lines are those from the opening to the closing brace.
struct Class {
    std::string name;
    int lines = 0;
};
std::vector<Class> classesOf(std::string_view source);

}  // namespace macula::test
