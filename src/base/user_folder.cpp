#include "base/user_folder.h"

#include <pwd.h>
#include <unistd.h>

#include <cstdlib>

namespace macula {

namespace fs = std::filesystem;

fs::path userDataFolder() {
    // The XDG specification says to ignore a relative path.
    if (const char* data = std::getenv("XDG_DATA_HOME"); data != nullptr && fs::path(data).is_absolute())
        return fs::path(data) / "macula";
    const char* home = std::getenv("HOME");
    if (home == nullptr || *home == '\0') {
        const passwd* user = getpwuid(geteuid());
        home = user != nullptr ? user->pw_dir : "/";
    }
    return fs::path(home) / ".local" / "share" / "macula";
}

}  // namespace macula
