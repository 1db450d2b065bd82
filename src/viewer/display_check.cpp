#include "viewer/display_check.h"

#ifdef __linux__
#include <dlfcn.h>

#include <cstdlib>
#include <string_view>
#endif

namespace macula::viewer {

#ifdef __linux__

namespace {

std::string_view variable(const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr ? value : "";
}

// DISPLAY outlives its server: in a terminal kept open, over a connection that was cut. The library is loaded
// by name, because Qt brings it along without its headers. Where it is missing, Qt is left to find out.
bool xServerAnswers() {
    struct Connection;
    void* library = dlopen("libxcb.so.1", RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) return true;
    const auto connect = reinterpret_cast<Connection* (*)(const char*, int*)>(dlsym(library, "xcb_connect"));
    const auto hasError = reinterpret_cast<int (*)(Connection*)>(dlsym(library, "xcb_connection_has_error"));
    const auto disconnect = reinterpret_cast<void (*)(Connection*)>(dlsym(library, "xcb_disconnect"));
    bool answers = true;
    if (connect != nullptr && hasError != nullptr && disconnect != nullptr) {
        Connection* connection = connect(nullptr, nullptr);  // never null
        answers = hasError(connection) == 0;
        disconnect(connection);
    }
    dlclose(library);
    return answers;
}

}  // namespace

bool hasDisplay() {
    const std::string_view platform = variable("QT_QPA_PLATFORM");
    if (platform.starts_with("xcb")) return xServerAnswers();
    if (!platform.empty() || !variable("WAYLAND_DISPLAY").empty()) return true;
    return !variable("DISPLAY").empty() && xServerAnswers();
}

#else

bool hasDisplay() {
    return true;
}

#endif

}  // namespace macula::viewer
