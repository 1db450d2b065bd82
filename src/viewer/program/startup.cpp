#include "viewer/program/startup.h"

#include <QSettings>
#include <clocale>
#include <cstdio>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "base/core_dumps.h"
#include "base/exit_codes.h"
#include "viewer/program/display_check.h"
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

}  // namespace

QStringList startProgram(const char* name, const char* version, int argc, char** argv) {
    switchCoreDumpsOff();
    returnFreedMemory();
    // The loader of headsets is not to write to the terminal (xr/loader.cpp); later, other threads would read
    // the environment meanwhile.
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
