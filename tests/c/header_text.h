// The headers of the C interface, as text.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "base/paths.h"

namespace macula::test {

// What macula.h includes, by name.
inline std::vector<std::filesystem::path> headers() {
    std::vector<std::filesystem::path> found;
    for (const auto& entry : std::filesystem::directory_iterator(projectFolder() / "src/c/include/macula"))
        found.push_back(entry.path());
    std::ranges::sort(found);
    return found;
}

// All of them, one after the other.
inline std::string headerText() {
    std::string text;
    for (const auto& header : headers()) {
        std::ifstream stream(header);
        text.append(std::istreambuf_iterator<char>(stream), {});
    }
    return text;
}

}  // namespace macula::test
