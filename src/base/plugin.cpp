#include "base/plugin.h"

#include <dlfcn.h>

#include <filesystem>
#include <string>

namespace macula {

namespace {

namespace fs = std::filesystem;

fs::path folderOfThis() {
    Dl_info info{};
    std::error_code unknown;
    fs::path file;
    if (dladdr(reinterpret_cast<const void*>(&folderOfThis), &info) != 0) file = info.dli_fname;
    // For a program, dladdr gives argv[0], which is relative if the shell found the program through PATH.
    if (!file.is_absolute()) file = "/proc/self/exe";
    return fs::canonical(file, unknown).parent_path();
}

}  // namespace

Result<void*> symbolOfPlugin(const char* name, const char* symbol) {
    const fs::path folder = folderOfThis();
    const std::string file = std::string(name) + ".so";
    std::string why;
    // In a build folder, next to this file; as seen from an installed program; as seen from an installed
    // library.
    for (const fs::path& place :
         {folder / file, folder / MACULA_PLUGINS_FROM_BIN / file, folder / "macula" / file}) {
        void* loaded = dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (loaded == nullptr) {
            // Reports the reason of the place where the file exists, if it exists in one of them.
            std::error_code unknown;
            if (why.empty() || fs::exists(place, unknown)) why = dlerror();
            continue;
        }
        if (void* found = dlsym(loaded, symbol); found != nullptr) return found;
        why = dlerror();
    }
    return Error{ErrorCode::deviceNotUsable, Text("A part of Macula could not be loaded."), why,
                 Text("Install Macula again, with the packages that it depends on.")};
}

}  // namespace macula
