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
        setenv("MACULA_KERNELS", (folder_ / "kernels").c_str(), 1);
        unsetenv("MACULA_SESSIONS");
        unsetenv("MACULA_KEEP_DAYS");
    }
    ~OwnDataFolder() {
        std::error_code ignored;
        if (getpid() == process_) fs::remove_all(folder_, ignored);  // and not at the end of a fork
    }
    OwnDataFolder(const OwnDataFolder&) = delete;
    OwnDataFolder& operator=(const OwnDataFolder&) = delete;

  private:
    pid_t process_ = getpid();
    fs::path folder_;
};

const OwnDataFolder kFolder;

}  // namespace
