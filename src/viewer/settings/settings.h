// What a person wants of the program, whatever is open.
#pragma once

#include <QJsonObject>
#include <QMap>
#include <QString>
#include <filesystem>
#include <optional>

#include "base/result.h"
#include "viewer/language/language.h"

namespace macula::viewer {

inline constexpr int kMostKeptDays = 36500;
inline constexpr int kLeastModelCapMb = 100;
inline constexpr int kMostModelCapMb = 1'000'000;

struct Settings {
    std::optional<Language> language = {};  // nothing: that of the desktop
    bool highContrast = false;
    double fontScale = 1.0;
    QString sessionFolder = {};        // empty: session::defaultFolder()
    std::optional<int> keepDays = {};  // nothing: for ever
    int modelCapMb = 2000;             // all stored models together
    QString quality =
        QStringLiteral("high");           // of pictures that are saved: a name, see app::builtInQualities
    bool deidentifies = false;            // DICOM pictures that are saved, unless somebody says otherwise
    bool showsNames = true;               // over the picture, when the window opens
    QMap<QString, QString> keys = {};     // that were chosen: see KeyBook
    QMap<QString, QString> folders = {};  // see LastFolders
    QString windowPlace = {};             // see WindowPlace; empty: as the program has it
    QJsonObject others = {};              // of a later version: written again as they are

    bool operator==(const Settings&) const = default;
};

// $XDG_DATA_HOME/macula/settings.json, or where the desktop has such files.
std::filesystem::path settingsFile();

// A value that is none of its kind counts as not there. Fails where the text is no JSON object.
Result<Settings> settingsFromJson(const std::string& text);
std::string toJson(const Settings& settings);

// `stored` with what a person has changed from `before` to `after`: all else may have been changed by another
// window meanwhile. Each key is one thing.
Settings withChanges(Settings stored, const Settings& before, const Settings& after);

// Where there is no file, settings as nobody has changed them.
Result<Settings> readSettings(const std::filesystem::path& file);
// Makes the folder. A file that cannot be read as settings is kept beside it, with ".damaged" behind its
// name.
Result<void> writeSettings(const Settings& settings, const std::filesystem::path& file);

}  // namespace macula::viewer
