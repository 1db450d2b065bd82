// macula-viewer: the window on a study.
#include "viewer/window/main_window.h"  // before Qt, see vulkan_window.h

#include <QApplication>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMessageBox>
#include <QScreen>
#include <QSessionManager>
#include <QSettings>
#include <QTemporaryDir>
#include <clocale>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <type_traits>
#include <utility>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "base/core_dumps.h"
#include "base/exit_codes.h"
#include "live/device/open_device.h"
#include "live/quality/calibration.h"
#include "live/quality/quality_front.h"
#include "session/store.h"
#include "viewer/command_line.h"
#include "viewer/display_check.h"
#include "viewer/driven/changes_script.h"
#include "viewer/driven/orbit_script.h"
#include "viewer/driven/stations_script.h"
#include "viewer/driven/workday_script.h"
#include "viewer/language/language.h"
#include "viewer/language/window_language.h"
#include "viewer/quit_signals.h"
#include "viewer/settings/settings.h"
#include "viewer/theme/theme.h"

namespace {

using namespace macula;
using namespace macula::viewer;

constexpr double kShareOfScreen = 0.9;  // for four panes

int fail(const Error& error) {
    std::fprintf(stderr, "macula-viewer: %s%s%s%s %s\n", error.message.english().c_str(),
                 error.where.empty() ? "" : " (", error.where.c_str(), error.where.empty() ? "" : ")",
                 error.hint.english().c_str());
    return exitCodeOf(error.code);
}

Result<MainWindowOptions> windowOptions(const CommandLine& line) {
    MACULA_TRY(scene::Catalogue catalogue, scene::builtInCatalogue());
    MainWindowOptions options{.catalogue = std::move(catalogue), .device = line.device.toStdString()};
    if (!line.preset.isEmpty()) {
        MACULA_TRY(options.preset, scene::findPreset(options.catalogue, line.preset.toStdString()));
    }
    if (!line.lights.isEmpty()) {
        MACULA_TRY(options.lights, scene::findLights(options.catalogue, line.lights.toStdString()));
    }
    options.firstView = line.view;
    options.layout = line.layout;
    options.choosesSize = line.size.has_value() || line.script != CommandLine::Script::none;
    if (line.size) {
        options.pictureSize = *line.size;
    } else if (line.layout == scene::Layout::fourPanes) {
        options.pictureSize = QGuiApplication::primaryScreen()->availableSize() * kShareOfScreen;
    }
    options.sampleLimit = line.samples;
    options.usesModel = line.usesModel;
    options.namesPatient = line.namesPatient;
    if (line.keepsStudies)
        options.sessions =
            line.sessions ? std::filesystem::path(line.sessions->toStdString()) : session::defaultFolder();
    options.keepDays = line.keepDays;
    options.calibrates = line.script == CommandLine::Script::none;
    using Script = CommandLine::Script;
    const bool asLeft = line.script == Script::none || line.script == Script::opening;
    options.restores = !asLeft ? Restores::nothing : line.choosesView ? Restores::work : Restores::all;
    options.keepsLayout = line.choosesLayout;
    options.showsInHeadset = line.showsInHeadset;
    return options;
}

// Each thread keeps blocks of up to 32 MiB that it freed for its next ones (mallopt(3)). Volumes and pictures
// of ever other sizes leave hundreds of MiB behind that way, which go back to the system by this.
void returnFreedMemory() {
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 1 << 20);
#endif
}

// A script measures what the command line says, and nothing else.
struct ReadSettings {
    Settings settings = {};
    std::optional<std::filesystem::path> file = {};  // where they are kept; nothing: nowhere
    std::optional<Error> error = {};
};

ReadSettings readSettingsFor(const CommandLine& line) {
    ReadSettings read;
    if (line.script != CommandLine::Script::none) return read;
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
    std::optional<std::filesystem::path> folder;
    if (line.keepsStudies)
        folder =
            line.sessions ? std::filesystem::path(line.sessions->toStdString()) : session::defaultFolder();
    Progress progress;
    const auto front = live::builtInQualityFront();
    if (!front) return fail(front.error());
    const auto measured = live::calibrationOf(line.device.toStdString(), folder, true, progress);
    if (!measured) return fail(measured.error());
    std::printf("%s: %.1f ms, %.2f times the machine that the quality slider was measured on.\n",
                measured->device.c_str(), measured->traceMs, measured->traceMs / front->calibrationMs);
    return kExitDone;
}

// Whoever ends the program from outside loses nothing of what was chosen and measured.
void keepWorkWhenAskedToEnd(QApplication& application, MainWindow& window, QuitSignals& quitSignals) {
    QObject::connect(&quitSignals, &QuitSignals::asked, &window, [&window] {
        window.keepStateNow();
        QCoreApplication::exit(kExitCancelled);
    });
    // A desktop that logs out ends the program when it has heard this, or asks the window to close first.
    QObject::connect(
        &application, &QGuiApplication::commitDataRequest, &window,
        [&window](QSessionManager& manager) {
            window.keepStateNow();
            if (!window.isWriting() || !manager.allowsInteraction()) return;
            manager.cancel();
            manager.release();
            window.close();  // which asks
        },
        Qt::DirectConnection);
}

// `report`: of the script `session`, where that is wanted; of `opening` it goes to standard output.
int run(QApplication& application, const CommandLine& line, const ReadSettings& read,
        QJsonObject* report = nullptr) {
    Result<MainWindowOptions> options = windowOptions(line);
    if (!options) return fail(options.error());
    options->settings = read.settings;
    options->settingsFile = read.file;
    Result<gpu::Instance> instance = createInstanceForWindows();
    if (!instance) {
        const int code = fail(instance.error());
        // Started from a desktop, nobody sees the standard error stream.
        if (line.script == CommandLine::Script::none) {
            QMessageBox::critical(nullptr, QStringLiteral("Macula"), inWindowsLanguage(instance.error()));
        }
        return code;
    }
    MainWindow window(*std::move(instance), *std::move(options));
    QuitSignals quitSignals;
    keepWorkWhenAskedToEnd(application, window, quitSignals);
    const study::StudySource source =
        line.folder ? study::StudySource(line.folder->toStdString()) : study::StudySource();
    std::optional<OrbitScript> orbit;
    std::optional<ChangesScript> changes;
    std::optional<WorkdayScript> session;
    std::optional<StationsScript> stations;
    const auto begin = [&](auto& script) {
        using Script = std::decay_t<decltype(*script)>;
        QObject::connect(&*script, &Script::finished, &application,
                         [](int code) { QCoreApplication::exit(code); });
        script->start();
    };
    if (line.script == CommandLine::Script::orbit) {
        orbit.emplace(window, OrbitScriptOptions{.screenshotFolder = line.screenshots,
                                                 .waitSeconds = line.waitSeconds,
                                                 .turnSeconds = line.turnSeconds,
                                                 .seconds = line.seconds,
                                                 .restSeconds = line.restSeconds});
        begin(orbit);
    } else if (line.script == CommandLine::Script::changes) {
        changes.emplace(window, ChangesScriptOptions{.study = source, .seconds = line.seconds});
        begin(changes);
    } else if (line.script == CommandLine::Script::session || line.script == CommandLine::Script::opening) {
        WorkdayScriptOptions wanted;
        wanted.study = source;
        wanted.opensOnly = line.script == CommandLine::Script::opening;
        wanted.work.orbitSeconds = line.seconds;
        wanted.work.turnSeconds = line.turnSeconds;
        if (!line.usesModel) wanted.modelSeconds = 0.0;
        session.emplace(window, std::move(wanted));
        begin(session);
    } else if (line.script == CommandLine::Script::stations) {
        StationsScriptOptions wanted;
        wanted.folder = line.screenshots;
        wanted.until = line.lastStation;
        if (line.waitSeconds > 0.0) wanted.waitSeconds = line.waitSeconds;
        stations.emplace(window, std::move(wanted));
        begin(stations);
    }
    window.show();
    if (read.error) window.tell(*read.error);
    window.open(source);
    const int code = application.exec();
    if (session && report != nullptr) {
        *report = session->report();
    } else if (session) {
        std::fputs(QJsonDocument(session->report()).toJson().constData(), stdout);
    }
    return code;
}

// The window is gone, and has saved what was learnt, before the study is opened again.
int runSession(QApplication& application, CommandLine line, const ReadSettings& read) {
    const QTemporaryDir own;
    if (!line.keepsStudies) {
        if (!own.isValid())
            return fail({ErrorCode::outputNotWritable,
                         Text("There is no folder for what the session keeps."),
                         {},
                         Text("Say --sessions FOLDER, or set TMPDIR.")});
        line.sessions = own.path();
        line.keepsStudies = true;
    }
    QJsonObject report;
    const int code = run(application, line, read, &report);
    QStringList again;
    if (line.folder) again << *line.folder;
    again << QStringLiteral("--script") << QStringLiteral("opening") << QStringLiteral("--sessions")
          << *line.sessions;
    if (!line.device.isEmpty()) again << QStringLiteral("--device") << line.device;
    if (line.size)
        again << QStringLiteral("--size")
              << QStringLiteral("%1x%2").arg(line.size->width()).arg(line.size->height());
    if (!line.usesModel) again << QStringLiteral("--no-model");
    return reportSession(code, report, again);
}

}  // namespace

int main(int argc, char** argv) {
    switchCoreDumpsOff();
    returnFreedMemory();
    // The loader of headsets is not to write to the terminal (xr/loader.cpp); later, other threads would read
    // the environment meanwhile.
    qputenv("XR_LOADER_DEBUG", qgetenv("XR_LOADER_DEBUG").isEmpty() ? "none" : qgetenv("XR_LOADER_DEBUG"));
    QCoreApplication::setApplicationName(QStringLiteral("macula-viewer"));
    QCoreApplication::setApplicationVersion(QStringLiteral(MACULA_VERSION));
    QStringList arguments;
    for (int i = 0; i < argc; ++i) arguments << QString::fromLocal8Bit(argv[i]);
    // Before the application object: --help and wrong options need no display.
    const Result<CommandLine> line = parseCommandLine(arguments);
    if (!line) return fail(line.error());
    if (line->print) {
        std::fputs(line->print->toLocal8Bit().constData(), stdout);
        return kExitDone;
    }
    live::keepKernelsIn(live::usualKernelsFolder());
    if (line->calibrates) return calibrate(withSettings(*line, readSettingsFor(*line).settings));
    std::optional<DisplayCheck> display(std::in_place);
    if (!display->found()) {
        return fail({ErrorCode::deviceNotUsable,
                     Text("There is no display to open a window on, or it does not answer."),
                     {},
                     Text("Set DISPLAY or WAYLAND_DISPLAY, or use `macula render`, which needs none.")});
    }
    // Qt's dialogs write the folders they were in to its settings, and the names of folders may be those of
    // patients. Below a file that is no folder nothing can be written.
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, QStringLiteral("/dev/null"));
    QApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C");  // Qt set that of the desktop, and libraries write files with it
    const ReadSettings read = readSettingsFor(*line);
    const CommandLine wanted = withSettings(*line, read.settings);
    const bool isScript = wanted.script != CommandLine::Script::none;
    useLanguage(wanted.language.value_or(isScript ? Language::english : desktopLanguage()));
    applyTheme(application, {.highContrast = wanted.highContrast, .fontScale = wanted.fontScale});
    display.reset();
    if (wanted.script == CommandLine::Script::session) return runSession(application, wanted, read);
    return run(application, wanted, read);
}
