#include "viewer/program/window_options.h"

#include <QScreen>
#include <QSessionManager>
#include <utility>

#include "base/exit_codes.h"
#include "session/store.h"

namespace macula::viewer {

namespace {

constexpr double kShareOfScreen = 0.9;  // for four panes

}  // namespace

std::optional<std::filesystem::path> sessionsOf(const CommandLine& line) {
    if (!line.keepsStudies) return std::nullopt;
    return line.sessions ? std::filesystem::path(line.sessions->toStdString()) : session::defaultFolder();
}

study::StudySource sourceOf(const CommandLine& line) {
    return line.folder ? study::StudySource(line.folder->toStdString()) : study::StudySource();
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
    options.choosesSize = line.size.has_value();
    if (line.size) {
        options.pictureSize = *line.size;
    } else if (line.layout == scene::Layout::fourPanes) {
        options.pictureSize = QGuiApplication::primaryScreen()->availableSize() * kShareOfScreen;
    }
    options.sampleLimit = line.samples;
    options.usesModel = line.usesModel;
    options.sessions = sessionsOf(line);
    options.keepDays = line.keepDays;
    options.calibrates = true;
    options.restores = line.choosesView ? Restores::work : Restores::all;
    options.keepsLayout = line.choosesLayout;
    options.showsInHeadset = line.showsInHeadset;
    return options;
}

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

}  // namespace macula::viewer
