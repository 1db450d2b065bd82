#include "viewer/program/startup.h"

#include <QSettings>
#include <clocale>
#include <cstdio>

#ifdef __GLIBC__
#include <malloc.h>
#endif
#ifdef __linux__
#include <dlfcn.h>

#include <cstdlib>
#include <string_view>
#endif

#include "base/core_dumps.h"
#include "base/exit_codes.h"
#include "viewer/theme/theme.h"

namespace macula::viewer {

namespace {

// Each thread keeps blocks of up to 32 MiB that it freed for its next ones (mallopt(3)). Volumes and pictures
// of ever other sizes leave hundreds of MiB behind that way, which go back to the system by this.
void returnFreedMemory() {
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 1 << 20);
#endif
}

// Without a display Qt aborts; the caller can print a message instead. Needs no QApplication.
//
// Keep it until the QApplication exists: a virtual display (Xvfb without -noreset) resets when its last
// client leaves, and is unavailable for the moment in which Qt would connect.
class DisplayCheck {
  public:
    DisplayCheck();
    ~DisplayCheck();
    DisplayCheck(const DisplayCheck&) = delete;
    DisplayCheck& operator=(const DisplayCheck&) = delete;

    bool found() const { return found_; }

  private:
    void connectToX();

    bool found_ = true;
    void* library_ = nullptr;     // libxcb
    void* connection_ = nullptr;  // xcb_connection_t
};

#ifdef __linux__

std::string_view variable(const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr ? value : "";
}

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

}  // namespace

QStringList startProgram(const char* name, const char* version, int argc, char** argv) {
    switchCoreDumpsOff();
    returnFreedMemory();
    // The loader of headsets is not to write to the terminal (xr/runtime.cpp); later, other threads would
    // read the environment meanwhile.
    qputenv("XR_LOADER_DEBUG", qgetenv("XR_LOADER_DEBUG").isEmpty() ? "none" : qgetenv("XR_LOADER_DEBUG"));
    QCoreApplication::setApplicationName(QLatin1String(name));
    QCoreApplication::setApplicationVersion(QLatin1String(version));
    QStringList arguments;
    for (int i = 0; i < argc; ++i) arguments << QString::fromLocal8Bit(argv[i]);
    return arguments;
}

Result<std::unique_ptr<QApplication>> openApplication(int& argc, char** argv) {
    const DisplayCheck display;
    if (!display.found())
        return Error{ErrorCode::deviceNotUsable,
                     Text("There is no display to open a window on, or it does not answer."),
                     {},
                     Text("Set DISPLAY or WAYLAND_DISPLAY, or use `macula render`, which needs none.")};
    // Qt's dialogs write the folders they were in to its settings, and the names of folders may be those of
    // patients. Below a file that is no folder nothing can be written.
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, QStringLiteral("/dev/null"));
    auto application = std::make_unique<QApplication>(argc, argv);
    std::setlocale(LC_NUMERIC, "C");  // Qt set that of the desktop, and libraries write files with it
    return application;
}

void useLanguageAndTheme(QApplication& application, const CommandLine& line, Language otherwise) {
    useLanguage(line.language.value_or(otherwise));
    applyTheme(application, {.highContrast = line.highContrast, .fontScale = line.fontScale});
}

int tellError(const Error& error) {
    const std::string where = error.where.empty() ? std::string() : " (" + error.where + ")";
    tellError(QString::fromStdString(error.message.english() + where + " " + error.hint.english()));
    return exitCodeOf(error.code);
}

void tellError(const QString& sentence) {
    std::fprintf(stderr, "%s: %s\n", QCoreApplication::applicationName().toUtf8().constData(),
                 sentence.toUtf8().constData());
}

}  // namespace macula::viewer
