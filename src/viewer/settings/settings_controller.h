// Asks for the settings of the program, applies and stores them.
#pragma once

#include <QObject>
#include <filesystem>
#include <optional>

#include "viewer/settings/settings.h"

class QAction;
class QMainWindow;
class QMenu;

namespace macula::viewer {

class Notifications;

// Window and notifications outlive it. Lives on the UI thread.
class SettingsController : public QObject {
    Q_OBJECT

  public:
    // `file`: where to keep them; nothing: they are not kept.
    SettingsController(QMainWindow& window, Notifications& notifications, Settings settings,
                       std::optional<std::filesystem::path> file);

    const Settings& settings() const { return settings_; }
    void take(const Settings& settings);  // applies and stores them
    void keepFolders(const QMap<QString, QString>& folders);
    void keepWindowPlace(const QString& place);
    void keepLayouts(const QMap<QString, QString>& layouts);
    void keepArchiveColumns(const QString& columns);
    void keepWatched(const QStringList& folders);
    void keepArchive(const QString& name);

    QAction* addAction(QMenu& edit);
    // Gives the actions of the window the keys that a person chose. Call it once, when all actions exist and
    // have their usual keys.
    void useKeys();

  Q_SIGNALS:
    void aboutToAsk();  // to end a drag: the dialog gets the button's release
    void namesToggled(bool shown);
    void receivingChanged();

  private:
    void ask();

    QMainWindow& window_;
    Notifications& notifications_;
    Settings settings_;
    std::optional<std::filesystem::path> file_;
};

}  // namespace macula::viewer
