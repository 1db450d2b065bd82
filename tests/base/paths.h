// Where the project and the data shared beside it lie. Only paths.cpp is compiled with these places: a clone
// elsewhere takes all else from the compiler's cache.
#pragma once

#include <filesystem>

namespace macula::test {

std::filesystem::path projectFolder();
std::filesystem::path sharedFolder();  // need not exist

}  // namespace macula::test
