#include "viewer/settings/settings.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QStandardPaths>
#include <cmath>
#include <iterator>
#include <limits>
#include <system_error>

#include "base/atomic_file.h"
#include "viewer/theme/theme.h"

namespace macula::viewer {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = 1u << 20;
constexpr int kVersion = 1;

constexpr const char* kPriorSearches[] = {"none", "list", "fetch"};

PriorSearch priorSearchOf(const QString& name) {
    for (std::size_t i = 0; i < std::size(kPriorSearches); ++i) {
        if (name == QLatin1String(kPriorSearches[i])) return PriorSearch(i);
    }
    return Settings{}.priors;
}

// Takes members out of the object; the unknown ones are left.
class Members {
  public:
    explicit Members(QJsonObject object) : object_(std::move(object)) {}

    QString text(const QString& name, const QString& otherwise) {
        const QJsonValue value = object_.take(name);
        return value.isString() ? value.toString() : otherwise;
    }
    bool flag(const QString& name, bool otherwise) {
        const QJsonValue value = object_.take(name);
        return value.isBool() ? value.toBool() : otherwise;
    }
    std::optional<double> number(const QString& name, double least, double most) {
        const double value = object_.take(name).toDouble(std::nan(""));
        return value >= least && value <= most ? std::optional(value) : std::nullopt;
    }
    std::optional<int> whole(const QString& name, int least, int most) {
        const std::optional<double> value = number(name, least, most);
        return value && *value == std::floor(*value) ? std::optional(int(*value)) : std::nullopt;
    }
    QMap<QString, QString> texts(const QString& name) {
        QMap<QString, QString> texts;
        const QJsonObject object = object_.take(name).toObject();
        for (auto text = object.begin(); text != object.end(); ++text)
            if (text->isString()) texts.insert(text.key(), text->toString());
        return texts;
    }
    QJsonObject object(const QString& name) { return object_.take(name).toObject(); }
    QStringList list(const QString& name, std::size_t most) {
        QStringList texts;
        for (const QJsonValue& value : object_.take(name).toArray()) {
            if (value.isString() && !texts.contains(value.toString()) && std::size_t(texts.size()) < most)
                texts.append(value.toString());
        }
        return texts;
    }
    QJsonObject rest() const { return object_; }

  private:
    QJsonObject object_;
};

Error notReadable() {
    return {ErrorCode::inputNotUsable,
            Text("The file of settings is damaged."),
            {},
            Text("The usual settings are taken; what you set next is saved, and the damaged file is kept.")};
}

}  // namespace

fs::path settingsFile() {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation);
    return fs::path(folder.toStdString()) / "macula" / "settings.json";
}

Result<Settings> settingsFromJson(const std::string& text) {
    const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(text));
    if (!document.isObject()) return notReadable();
    Members members(document.object());
    Settings settings;
    members.whole(QStringLiteral("version"), 0, std::numeric_limits<int>::max());
    settings.language = languageOf(members.text(QStringLiteral("language"), {}));
    settings.highContrast = members.flag(QStringLiteral("highContrast"), settings.highContrast);
    settings.fontScale = members.number(QStringLiteral("fontScale"), kSmallestFontScale, kLargestFontScale)
                             .value_or(settings.fontScale);
    settings.storeFolder = members.text(QStringLiteral("storeFolder"), {});
    settings.keepDays = members.whole(QStringLiteral("keepDays"), 1, kMostKeptDays);
    settings.modelCapMb = members.whole(QStringLiteral("modelCapMb"), kLeastModelCapMb, kMostModelCapMb)
                              .value_or(settings.modelCapMb);
    settings.quality = members.text(QStringLiteral("quality"), settings.quality);
    settings.deidentifies = members.flag(QStringLiteral("deidentifies"), settings.deidentifies);
    settings.showsNames = members.flag(QStringLiteral("showsNames"), settings.showsNames);
    settings.keys = members.texts(QStringLiteral("keys"));
    settings.folders = members.texts(QStringLiteral("folders"));
    settings.watchedFolders = members.list(QStringLiteral("watchedFolders"), kMostWatchedFolders);
    settings.windowPlace = members.text(QStringLiteral("windowPlace"), {});
    settings.priors = priorSearchOf(members.text(QStringLiteral("priors"), {}));
    settings.archiveColumns = members.text(QStringLiteral("archiveColumns"), {});
    settings.archive = members.text(QStringLiteral("archive"), {});
    settings.layouts = members.texts(QStringLiteral("layouts"));
    settings.mouse = members.text(QStringLiteral("mouse"), {});
    settings.receiving = receiveSettingsOf(members.object(QStringLiteral("receiving")));
    settings.others = members.rest();
    return settings;
}

std::string toJson(const Settings& settings) {
    QJsonObject object = settings.others;
    object[QStringLiteral("version")] = kVersion;
    if (settings.language) object[QStringLiteral("language")] = codeOf(*settings.language);
    object[QStringLiteral("highContrast")] = settings.highContrast;
    object[QStringLiteral("fontScale")] = settings.fontScale;
    if (!settings.storeFolder.isEmpty()) object[QStringLiteral("storeFolder")] = settings.storeFolder;
    if (settings.keepDays) object[QStringLiteral("keepDays")] = *settings.keepDays;
    object[QStringLiteral("modelCapMb")] = settings.modelCapMb;
    object[QStringLiteral("quality")] = settings.quality;
    object[QStringLiteral("deidentifies")] = settings.deidentifies;
    object[QStringLiteral("showsNames")] = settings.showsNames;
    object[QStringLiteral("priors")] = QLatin1String(kPriorSearches[std::size_t(settings.priors)]);
    if (!settings.mouse.isEmpty()) object[QStringLiteral("mouse")] = settings.mouse;
    if (!settings.archiveColumns.isEmpty())
        object[QStringLiteral("archiveColumns")] = settings.archiveColumns;
    const auto write = [&](const QString& name, const QMap<QString, QString>& texts) {
        QJsonObject members;
        for (auto text = texts.begin(); text != texts.end(); ++text) members[text.key()] = text.value();
        if (!members.isEmpty()) object[name] = members;
    };
    write(QStringLiteral("keys"), settings.keys);
    write(QStringLiteral("folders"), settings.folders);
    write(QStringLiteral("layouts"), settings.layouts);
    if (!settings.watchedFolders.isEmpty())
        object[QStringLiteral("watchedFolders")] = QJsonArray::fromStringList(settings.watchedFolders);
    if (!settings.windowPlace.isEmpty()) object[QStringLiteral("windowPlace")] = settings.windowPlace;
    if (!settings.archive.isEmpty()) object[QStringLiteral("archive")] = settings.archive;
    object[QStringLiteral("receiving")] = toJson(settings.receiving);
    return QJsonDocument(object).toJson(QJsonDocument::Indented).toStdString();
}

Settings withChanges(Settings stored, const Settings& before, const Settings& after) {
    const auto take = [&](auto Settings::*field) {
        if (after.*field != before.*field) stored.*field = after.*field;
    };
    take(&Settings::language);
    take(&Settings::highContrast);
    take(&Settings::fontScale);
    take(&Settings::storeFolder);
    take(&Settings::keepDays);
    take(&Settings::modelCapMb);
    take(&Settings::quality);
    take(&Settings::deidentifies);
    take(&Settings::showsNames);
    take(&Settings::windowPlace);
    take(&Settings::priors);
    take(&Settings::archiveColumns);
    for (const QString& folder : before.watchedFolders)
        if (!after.watchedFolders.contains(folder)) stored.watchedFolders.removeAll(folder);
    for (const QString& folder : after.watchedFolders)
        if (!before.watchedFolders.contains(folder) && !stored.watchedFolders.contains(folder))
            stored.watchedFolders.append(folder);
    take(&Settings::archive);
    take(&Settings::mouse);
    take(&Settings::receiving);
    for (auto field : {&Settings::keys, &Settings::folders, &Settings::layouts}) {
        const QMap<QString, QString>& old = before.*field;
        const QMap<QString, QString>& now = after.*field;
        for (auto text = old.begin(); text != old.end(); ++text)
            if (!now.contains(text.key())) (stored.*field).remove(text.key());
        for (auto text = now.begin(); text != now.end(); ++text)
            if (!old.contains(text.key()) || old[text.key()] != text.value())
                (stored.*field)[text.key()] = text.value();
    }
    return stored;
}

Result<Settings> readSettings(const fs::path& file) {
    std::error_code error;
    if (!fs::exists(file, error) && !error) return Settings{};
    MACULA_TRY(const std::string text, readText(file, kMostBytes));
    return settingsFromJson(text);
}

Result<void> writeSettings(const Settings& settings, const fs::path& file) {
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    if (error)
        return Error{ErrorCode::outputNotWritable,
                     Text("The settings could not be saved: their folder cannot be made."),
                     file.parent_path().string(), Text("Check free space and permissions.")};
    if (!readSettings(file)) fs::rename(file, fs::path(file).concat(".damaged"), error);
    MACULA_TRY_VOID(writeTextAtomically(file, toJson(settings)));
    // Names of folders are private.
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write, error);
    return {};
}

}  // namespace macula::viewer
