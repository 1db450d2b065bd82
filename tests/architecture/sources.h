// The sources of this repository, for tests that read them.
#pragma once

#include <filesystem>
#include <vector>

namespace macula::test {

// C++ and GLSL in a folder of the repository and the folders below it, in order of their names.
std::vector<std::filesystem::path> sourcesIn(const char* folder);

}  // namespace macula::test
