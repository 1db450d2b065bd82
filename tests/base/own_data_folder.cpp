// Part of every test: what programs keep of a person goes to a folder of this process, and of those that it
// starts, and never to that of whoever runs the tests.
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

namespace {

namespace fs = std::filesystem;

class OwnDataFolder {
  public:
    OwnDataFolder() {
        std::error_code error;
        const fs::path place = fs::temp_directory_path(error);
        folder_ = (error ? fs::path("/tmp") : place) / ("macula-data-" + std::to_string(process_));
        fs::remove_all(folder_, error);  // of a killed process of the same number
        setenv("XDG_DATA_HOME", folder_.c_str(), 1);
        // Not that of the person either, and not below: tests look at all that is there.
        setenv("MACULA_KERNELS", kernels().c_str(), 1);
        setenv("XDG_CONFIG_DIRS", (folder_ / "no-administrator").c_str(), 1);
        unsetenv("MACULA_SESSIONS");
        unsetenv("MACULA_KEEP_DAYS");
    }
    ~OwnDataFolder() {
        std::error_code ignored;
        if (getpid() != process_) return;  // at the end of a fork
        fs::remove_all(folder_, ignored);
        fs::remove_all(kernels(), ignored);
    }
    OwnDataFolder(const OwnDataFolder&) = delete;
    OwnDataFolder& operator=(const OwnDataFolder&) = delete;

  private:
    fs::path kernels() const { return folder_.string() + "-kernels"; }

    pid_t process_ = getpid();
    fs::path folder_;
};

const OwnDataFolder kFolder;

}  // namespace
