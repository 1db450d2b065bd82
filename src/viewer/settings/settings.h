// The settings of the program, independent of the study.
#pragma once

#include <QJsonObject>
#include <QMap>
#include <QString>
#include <QStringList>
#include <cstddef>
#include <filesystem>
#include <optional>

#include "base/result.h"
#include "viewer/language/language.h"
#include "viewer/settings/receive_settings.h"

namespace macula::viewer {

inline constexpr int kMostKeptDays = 36500;
inline constexpr int kLeastModelCapMb = 100;
inline constexpr int kMostModelCapMb = 1'000'000;
inline constexpr std::size_t kMostWatchedFolders = 16;

// What the window does about other studies of the patient whose study came from an archive.
enum class PriorSearch { none, list, fetch };

struct Settings {
    std::optional<Language> language = {};  // nothing: that of the desktop
    bool highContrast = false;
    double fontScale = 1.0;
    QString storeFolder = {};          // empty: session::defaultFolder()
    std::optional<int> keepDays = {};  // nothing: for ever
    int modelCapMb = 2000;             // for all stored models together
    QString quality =
        QStringLiteral("high");  // the quality of saved pictures, by its name in scene::builtInQualities
    bool deidentifies = false;   // the default for saved DICOM pictures
    bool showsNames = true;      // over the picture, when the window opens
    QMap<QString, QString> keys = {};     // chosen keys: see KeyBook
    QMap<QString, QString> folders = {};  // see LastFolders
    QStringList watchedFolders = {};      // see WatchController
    QString windowPlace = {};             // see WindowPlace; empty: the default
    PriorSearch priors = PriorSearch::list;
    QString archiveColumns = {};          // of the list of studies, see ArchivePanel; empty: the default
    QString archive = {};                 // the name of the one to which something was sent last
    QMap<QString, QString> layouts = {};  // see UsualLayouts
    QString mouse = {};                   // a MouseProfile by its name; empty: the first
    ReceiveSettings receiving = {};
    QJsonObject others = {};  // from a later version: written back unchanged

    bool operator==(const Settings&) const = default;
};

// $XDG_DATA_HOME/macula/settings.json, or the desktop's folder for such files.
std::filesystem::path settingsFile();

// An invalid value counts as missing. Fails if the text is not a JSON object.
Result<Settings> settingsFromJson(const std::string& text);
std::string toJson(const Settings& settings);

// `stored` with the changes from `before` to `after`, because another window may have changed the rest. Each
// entry of `keys` and `folders` counts separately.
Settings withChanges(Settings stored, const Settings& before, const Settings& after);

// The default settings if there is no file.
Result<Settings> readSettings(const std::filesystem::path& file);
// Makes the folder. Renames an unreadable old file by appending ".damaged".
Result<void> writeSettings(const Settings& settings, const std::filesystem::path& file);

}  // namespace macula::viewer
