// macula-viewer-bench: scripts that drive the window, and measure it.
#include "viewer/window/main_window.h"  // before Qt, see vulkan_window.h

#include <QApplication>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <cstdio>
#include <memory>
#include <utility>

#include "base/exit_codes.h"
#include "live/device/open_device.h"
#include "viewer/driven/changes_script.h"
#include "viewer/driven/orbit_script.h"
#include "viewer/driven/script_line.h"
#include "viewer/driven/stations_script.h"
#include "viewer/driven/workday_script.h"
#include "viewer/program/quit_signals.h"
#include "viewer/program/startup.h"
#include "viewer/program/window_options.h"

namespace {

using namespace macula;
using namespace macula::viewer;
using Script = ScriptLine::Script;

// A script measures what the command line says, and nothing else.
Result<MainWindowOptions> drivenWindowOptions(const ScriptLine& line) {
    MACULA_TRY(MainWindowOptions options, windowOptions(line.window));
    options.namesPatient = line.namesPatient;
    options.choosesSize = true;
    options.calibrates = false;
    if (line.script != Script::opening) options.restores = Restores::nothing;
    return options;
}

OrbitScriptOptions orbitOptions(const ScriptLine& line) {
    return {.screenshotFolder = line.screenshots,
            .waitSeconds = line.waitSeconds,
            .turnSeconds = line.turnSeconds,
            .seconds = line.seconds,
            .restSeconds = line.restSeconds};
}

WorkdayScriptOptions workdayOptions(const ScriptLine& line) {
    WorkdayScriptOptions wanted;
    wanted.study = sourceOf(line.window);
    wanted.opensOnly = line.script == Script::opening;
    wanted.work.orbitSeconds = line.seconds;
    wanted.work.turnSeconds = line.turnSeconds;
    if (!line.window.usesModel) wanted.modelSeconds = 0.0;
    return wanted;
}

StationsScriptOptions stationsOptions(const ScriptLine& line) {
    StationsScriptOptions wanted;
    wanted.folder = line.screenshots;
    wanted.until = line.lastStation;
    if (line.waitSeconds > 0.0) wanted.waitSeconds = line.waitSeconds;
    return wanted;
}

// When it has finished, the program ends.
template <class Of, class Options>
std::unique_ptr<Of> begun(MainWindow& window, Options options) {
    auto script = std::make_unique<Of>(window, std::move(options));
    QObject::connect(script.get(), &Of::finished, qApp, [](int code) { QCoreApplication::exit(code); });
    script->start();
    return script;
}

// `report`: of the scripts `session` and `opening`.
int run(QApplication& application, const ScriptLine& line, QJsonObject& report) {
    Result<MainWindowOptions> options = drivenWindowOptions(line);
    if (!options) return tellError(options.error());
    Result<gpu::Instance> instance = createInstanceForWindows();
    if (!instance) return tellError(instance.error());
    MainWindow window(*std::move(instance), *std::move(options));
    QuitSignals quitSignals;
    keepWorkWhenAskedToEnd(application, window, quitSignals);
    std::unique_ptr<QObject> script;
    std::unique_ptr<WorkdayScript> workday;
    switch (line.script) {
        case Script::orbit:
            script = begun<OrbitScript>(window, orbitOptions(line));
            break;
        case Script::changes:
            script = begun<ChangesScript>(
                window, ChangesScriptOptions{.study = sourceOf(line.window), .seconds = line.seconds});
            break;
        case Script::session:
        case Script::opening:
            workday = begun<WorkdayScript>(window, workdayOptions(line));
            break;
        case Script::stations:
            script = begun<StationsScript>(window, stationsOptions(line));
            break;
    }
    window.show();
    window.open(sourceOf(line.window));
    const int code = QApplication::exec();
    if (workday) report = workday->report();
    return code;
}

// The window is gone, and has saved what was learnt, before the study is opened again.
int runSession(QApplication& application, ScriptLine line) {
    const QTemporaryDir own;
    CommandLine& window = line.window;
    if (!window.keepsStudies) {
        if (!own.isValid())
            return tellError({ErrorCode::outputNotWritable,
                              Text("There is no folder for what the session keeps."),
                              {},
                              Text("Say --sessions FOLDER, or set TMPDIR.")});
        window.sessions = own.path();
        window.keepsStudies = true;
    }
    QJsonObject report;
    const int code = run(application, line, report);
    QStringList again{QStringLiteral("opening")};
    if (window.folder) again << *window.folder;
    again << QStringLiteral("--sessions") << *window.sessions;
    if (!window.device.isEmpty()) again << QStringLiteral("--device") << window.device;
    if (window.size)
        again << QStringLiteral("--size")
              << QStringLiteral("%1x%2").arg(window.size->width()).arg(window.size->height());
    if (!window.usesModel) again << QStringLiteral("--no-model");
    return reportSession(code, report, again);
}

int runScript(QApplication& application, const ScriptLine& line) {
    if (line.script == Script::session) return runSession(application, line);
    QJsonObject report;
    const int code = run(application, line, report);
    if (!report.isEmpty()) std::fputs(QJsonDocument(report).toJson().constData(), stdout);
    return code;
}

}  // namespace

int main(int argc, char** argv) {
    const Result<ScriptLine> line =
        parseScriptLine(startProgram("macula-viewer-bench", MACULA_VERSION, argc, argv));
    if (!line) return tellError(line.error());
    if (line->window.print) {
        std::fputs(line->window.print->toLocal8Bit().constData(), stdout);
        return kExitDone;
    }
    live::keepKernelsIn(live::usualKernelsFolder());
    const auto application = openApplication(argc, argv);
    if (!application) return tellError(application.error());
    useLanguageAndTheme(**application, line->window, Language::english);
    return runScript(**application, *line);
}
