#include "viewer/settings/settings_controller.h"

#include <QApplication>
#include <QMainWindow>
#include <QMenu>
#include <utility>

#include "viewer/menus/controls.h"
#include "viewer/settings/key_book.h"
#include "viewer/settings/mouse_profile.h"
#include "viewer/settings/settings_dialog.h"
#include "viewer/status/notifications.h"
#include "viewer/theme/theme.h"

namespace macula::viewer {

SettingsController::SettingsController(QMainWindow& window, Notifications& notifications, Settings settings,
                                       std::optional<std::filesystem::path> file)
    : QObject(&window),
      window_(window),
      notifications_(notifications),
      settings_(std::move(settings)),
      file_(std::move(file)) {}

QAction* SettingsController::addAction(QMenu& edit) {
    QAction* settings = edit.addAction(tr("&Settings…"), this, &SettingsController::ask);
    describe(*settings, "settings", tr("Language, look, keys, and what is kept"));
    return settings;
}

void SettingsController::useKeys() {
    useMouseProfile(settings_.mouse);
    KeyBook& book = KeyBook::ofProgram();
    connect(&book, &KeyBook::changed, this, [this] { KeyBook::ofProgram().applyTo(window_); });
    book.setOwn(withoutTrouble(settings_.keys, KeyBook::entriesOf(window_)));
    book.applyTo(window_);
}

void SettingsController::ask() {
    Q_EMIT aboutToAsk();
    auto* dialog = new SettingsDialog(settings_, KeyBook::entriesOf(window_), file_.has_value(), &window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { take(dialog->settings()); });
    dialog->open();  // exec() would run a second event loop
}

void SettingsController::keepFolders(const QMap<QString, QString>& folders) {
    Settings settings = settings_;
    settings.folders = folders;
    take(settings);
}

void SettingsController::keepWindowPlace(const QString& place) {
    Settings settings = settings_;
    settings.windowPlace = place;
    take(settings);
}

void SettingsController::keepLayouts(const QMap<QString, QString>& layouts) {
    Settings settings = settings_;
    settings.layouts = layouts;
    take(settings);
}

void SettingsController::keepArchiveColumns(const QString& columns) {
    Settings settings = settings_;
    settings.archiveColumns = columns;
    take(settings);
}

void SettingsController::keepWatched(const QStringList& folders) {
    Settings settings = settings_;
    settings.watchedFolders = folders;
    take(settings);
}

void SettingsController::keepArchive(const QString& name) {
    Settings settings = settings_;
    settings.archive = name;
    take(settings);
}

void SettingsController::take(const Settings& settings) {
    const Settings before = std::exchange(settings_, settings);
    if (settings == before) return;
    if (settings.highContrast != before.highContrast || settings.fontScale != before.fontScale) {
        applyTheme(*qobject_cast<QApplication*>(QCoreApplication::instance()),
                   {.highContrast = settings.highContrast, .fontScale = settings.fontScale});
    }
    useMouseProfile(settings.mouse);
    if (settings.showsNames != before.showsNames) Q_EMIT namesToggled(settings.showsNames);
    if (settings.receiving != before.receiving) Q_EMIT receivingChanged();
    KeyBook::ofProgram().setOwn(settings.keys);
    if (!file_) return;
    const Result<Settings> stored = readSettings(*file_);
    const Result<void> written =
        writeSettings(stored ? withChanges(*stored, before, settings) : settings, *file_);
    if (!written) return notifications_.showError(written.error());
    const bool isForNextStart =
        settings.language != before.language || settings.storeFolder != before.storeFolder ||
        settings.keepDays != before.keepDays || settings.modelCapMb != before.modelCapMb;
    if (isForNextStart)
        notifications_.showNote(
            tr("The settings are saved. Language and sessions follow them from the next start."));
}

}  // namespace macula::viewer
