// The options of macula-viewer.
#pragma once

#include <QSize>
#include <QString>
#include <QStringList>
#include <cstdint>
#include <optional>

#include "base/frames.h"
#include "base/result.h"
#include "scene/state/study_state.h"
#include "viewer/settings/settings.h"

namespace macula::viewer {

struct CommandLine {
    std::optional<QString> folder;  // nothing: the phantom
    std::optional<QString> link;    // instead of a folder; not yet understood: the window says what is wrong
    bool isAlone = false;           // no option says how what is opened is to be shown
    QString preset;                 // empty: by modality
    QString lights;                 // empty: the default
    QString device;
    std::optional<ViewDirection> view = {};  // nothing: scene::usualView
    std::optional<QSize> size;               // of the picture
    scene::Layout layout = scene::Layout::fourPanes;
    bool choosesLayout = false;
    std::optional<Language> language = {};  // nothing: from the settings or the desktop
    bool highContrast = false;
    double fontScale = 1.0;
    bool choosesFontScale = false;
    std::uint32_t samples = 512;
    bool usesModel = true;
    bool keepsStudies = true;
    std::optional<QString> sessions;  // none: session::defaultFolder()
    std::optional<int> keepDays;      // deletes what was unopened for longer; nothing: never
    bool calibrates = false;          // only measures this machine's speed and prints it
    bool showsInHeadset = false;      // the study, once it is open
    bool choosesView = false;         // an option says how the study is shown
    std::optional<QString> print;     // the help or version text to print before exiting
};

// `arguments` begins with the program's name. Without --keep-days, MACULA_KEEP_DAYS of the environment
// counts. Fails with usage.
Result<CommandLine> parseCommandLine(const QStringList& arguments);

// Takes from `settings` what neither the command line nor the environment sets.
CommandLine withSettings(CommandLine line, const Settings& settings);

}  // namespace macula::viewer
