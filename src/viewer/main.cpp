// macula-viewer: the window on a study.
#include "viewer/window/main_window.h"  // before Qt, see vulkan_window.h

#include <QApplication>
#include <QMessageBox>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <utility>

#include "base/exit_codes.h"
#include "live/device/open_device.h"
#include "live/quality/calibration.h"
#include "live/quality/quality_front.h"
#include "unpack/unpacked_archive.h"
#include "viewer/language/language.h"
#include "viewer/language/window_language.h"
#include "viewer/links/link_socket.h"
#include "viewer/program/command_line.h"
#include "viewer/program/quit_signals.h"
#include "viewer/program/startup.h"
#include "viewer/program/window_options.h"
#include "viewer/settings/settings.h"

namespace {

using namespace macula;
using namespace macula::viewer;

struct ReadSettings {
    Settings settings = {};
    std::optional<std::filesystem::path> file = {};  // where they are kept; nothing: nowhere
    std::optional<Error> error = {};
};

ReadSettings readSettingsFor(const CommandLine& line) {
    ReadSettings read;
    const std::filesystem::path file = settingsFile();
    Result<Settings> settings = readSettings(file);
    if (settings) {
        read.settings = *std::move(settings);
    } else {
        read.error = settings.error();
    }
    if (line.keepsStudies) read.file = file;
    return read;
}

// Needs no display. `line` is with settings: what is measured goes to where the window looks for it.
int calibrate(const CommandLine& line) {
    Progress progress;
    const auto front = live::builtInQualityFront();
    if (!front) return tellError(front.error());
    const auto measured = live::calibrationOf(line.device.toStdString(), sessionsOf(line), true, progress);
    if (!measured) return tellError(measured.error());
    std::printf("%s: %.1f ms, %.2f times the machine that the quality slider was measured on.\n",
                measured->device.c_str(), measured->traceMs, measured->traceMs / front->calibrationMs);
    return kExitDone;
}

int run(QApplication& application, const CommandLine& line, const ReadSettings& read) {
    Result<MainWindowOptions> options = windowOptions(line);
    if (!options) return tellError(options.error());
    options->settings = read.settings;
    options->settingsFile = read.file;
    Result<gpu::Instance> instance = createInstanceForWindows();
    if (!instance) {
        const int code = tellError(instance.error());
        // Started from a desktop, nobody sees the standard error stream.
        QMessageBox::critical(nullptr, QStringLiteral("Macula"), inWindowsLanguage(instance.error()));
        return code;
    }
    MainWindow window(*std::move(instance), *std::move(options));
    QuitSignals quitSignals;
    keepWorkWhenAskedToEnd(application, window, quitSignals);
    window.show();
    if (read.error) window.tell(*read.error);
    LinkServer server;
    QObject::connect(&server, &LinkServer::linkCame, &window, &MainWindow::openLink);
    if (line.link) {
        window.openLink(*line.link);
    } else {
        window.open(sourceOf(line));
    }
    return QApplication::exec();
}

}  // namespace

int main(int argc, char** argv) {
    const Result<CommandLine> line =
        parseCommandLine(startProgram("macula-viewer", MACULA_VERSION, argc, argv));
    if (!line) return tellError(line.error());
    if (line->print) {
        std::fputs(line->print->toLocal8Bit().constData(), stdout);
        return kExitDone;
    }
    live::keepKernelsIn(live::usualKernelsFolder());
    unpack::removeAbandoned();
    const ReadSettings read = readSettingsFor(*line);
    const CommandLine wanted = withSettings(*line, read.settings);
    if (wanted.calibrates) return calibrate(wanted);
    const auto application = openApplication(argc, argv);
    if (!application) return tellError(application.error());
    if (wanted.link && wanted.isAlone && handOver(*wanted.link)) return kExitDone;
    useLanguageAndTheme(**application, wanted, desktopLanguage());
    return run(**application, wanted, read);
}
