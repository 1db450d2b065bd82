#include "base/paths.h"

namespace macula::test {

std::filesystem::path projectFolder() {
    return MACULA_PROJECT_FOLDER;
}

std::filesystem::path sharedFolder() {
    return MACULA_PROJECT_FOLDER "/../shared";
}

}  // namespace macula::test
