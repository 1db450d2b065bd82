#include "base/module.h"

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
    // Of a program it is the word that it was called by, which may have been found by PATH.
    if (!file.is_absolute()) file = "/proc/self/exe";
    return fs::canonical(file, unknown).parent_path();
}

}  // namespace

Result<void*> symbolOfModule(const char* module, const char* symbol) {
    const fs::path folder = folderOfThis();
    const std::string file = std::string(module) + ".so";
    std::string why;
    for (const fs::path& place : {folder / file, folder / MACULA_MODULES_FROM_BIN / file}) {
        void* loaded = dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (loaded == nullptr) {
            // Of the place where it is, if it is at one.
            std::error_code unknown;
            if (why.empty() || fs::exists(place, unknown)) why = dlerror();
            continue;
        }
        if (void* found = dlsym(loaded, symbol); found != nullptr) return found;
        why = dlerror();
    }
    return Error{ErrorCode::deviceNotUsable, "A part of Macula could not be loaded.", why,
                 "Install Macula again, with the packages that it depends on."};
}

}  // namespace macula
