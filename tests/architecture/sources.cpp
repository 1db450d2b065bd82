#include "architecture/sources.h"

#include <algorithm>
#include <set>
#include <string>

#include "base/paths.h"

namespace macula::test {

std::vector<std::filesystem::path> sourcesIn(const char* folder) {
    static const std::set<std::string> kExtensions{".h", ".cpp", ".inl", ".glsl", ".comp", ".vert", ".frag"};
    namespace fs = std::filesystem;
    std::vector<fs::path> files;
    if (!fs::is_directory(projectFolder() / folder)) return files;
    for (const auto& entry : fs::recursive_directory_iterator(projectFolder() / folder)) {
        if (entry.is_regular_file() && kExtensions.contains(entry.path().extension().string()))
            files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace macula::test
