#include "viewer/program/display_check.h"

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

}  // namespace

DisplayCheck::DisplayCheck() {
    const std::string_view platform = variable("QT_QPA_PLATFORM");
    if (platform.starts_with("xcb")) {
        connectToX();
    } else if (platform.empty() && variable("WAYLAND_DISPLAY").empty()) {
        found_ = !variable("DISPLAY").empty();
        if (found_) connectToX();
    }
}

// DISPLAY outlives its server in a terminal that stays open, or after a connection broke. Loads the library
// by name, because Qt ships it without its headers. If it is missing, Qt reports the missing display.
void DisplayCheck::connectToX() {
    library_ = dlopen("libxcb.so.1", RTLD_NOW | RTLD_LOCAL);
    if (library_ == nullptr) return;
    const auto connect = reinterpret_cast<void* (*)(const char*, int*)>(dlsym(library_, "xcb_connect"));
    const auto hasError = reinterpret_cast<int (*)(void*)>(dlsym(library_, "xcb_connection_has_error"));
    if (connect == nullptr || hasError == nullptr) return;
    connection_ = connect(nullptr, nullptr);  // never null
    found_ = hasError(connection_) == 0;
}

DisplayCheck::~DisplayCheck() {
    if (library_ == nullptr) return;
    const auto disconnect = reinterpret_cast<void (*)(void*)>(dlsym(library_, "xcb_disconnect"));
    if (connection_ != nullptr && disconnect != nullptr) disconnect(connection_);
    dlclose(library_);
}

#else

DisplayCheck::DisplayCheck() = default;
DisplayCheck::~DisplayCheck() = default;

#endif

}  // namespace macula::viewer
