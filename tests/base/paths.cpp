#include "base/paths.h"

namespace macula::test {

std::filesystem::path projectFolder() {
    return MACULA_PROJECT_FOLDER;
}

std::filesystem::path sharedFolder() {
    return MACULA_PROJECT_FOLDER "/../shared";
}

std::size_t filesIn(const std::filesystem::path& folder, const std::string& ending) {
    std::size_t count = 0;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(projectFolder() / folder, error))
        count += entry.path().filename().string().ends_with(ending) ? 1 : 0;
    return count;
}

}  // namespace macula::test
