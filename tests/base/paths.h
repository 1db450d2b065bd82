// Where the project and the data shared beside it lie. Only paths.cpp is compiled with these places: a clone
// elsewhere takes all else from the compiler's cache.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace macula::test {

std::filesystem::path projectFolder();
std::filesystem::path sharedFolder();  // need not exist

// Files of that folder of the project that end so; 0 where there is no such folder.
std::size_t filesIn(const std::filesystem::path& folder, const std::string& ending);

}  // namespace macula::test
