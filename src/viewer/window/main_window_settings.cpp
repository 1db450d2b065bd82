// What a person wants of the program: asked for, used, and kept.
#include <QApplication>

#include "viewer/settings/settings_dialog.h"
#include "viewer/theme/theme.h"
#include "viewer/window/main_window.h"

namespace macula::viewer {

// Last: all actions are there, with the keys that they come with.
void MainWindow::useKeys() {
    KeyBook& book = KeyBook::ofProgram();
    connect(&book, &KeyBook::changed, this, [this] { KeyBook::ofProgram().applyTo(*this); });
    book.setOwn(withoutTrouble(options_.settings.keys, KeyBook::entriesOf(*this)));
    book.applyTo(*this);
}

void MainWindow::askForSettings() {
    viewport_->window().endDrag();  // the dialog will see the button go up
    auto* dialog = new SettingsDialog(options_.settings, KeyBook::entriesOf(*this),
                                      options_.settingsFile.has_value(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { takeSettings(dialog->settings()); });
    dialog->open();  // exec() would run a second event loop
}

void MainWindow::keepFolders() {
    Settings settings = options_.settings;
    settings.folders = folders_.toKeep();
    takeSettings(settings);
}

void MainWindow::sawStudy(const QString& path) {
    folders_.sawStudy(path);
    keepFolders();
}

void MainWindow::takeSettings(const Settings& settings) {
    const Settings before = std::exchange(options_.settings, settings);
    if (settings == before) return;
    if (settings.highContrast != before.highContrast || settings.fontScale != before.fontScale) {
        applyTheme(*qobject_cast<QApplication*>(QCoreApplication::instance()),
                   {.highContrast = settings.highContrast, .fontScale = settings.fontScale});
    }
    if (settings.showsNames != before.showsNames) showNames(options_.namesPatient && settings.showsNames);
    KeyBook::ofProgram().setOwn(settings.keys);
    if (!options_.settingsFile) return;
    const Result<Settings> stored = readSettings(*options_.settingsFile);
    const Result<void> written =
        writeSettings(stored ? withChanges(*stored, before, settings) : settings, *options_.settingsFile);
    if (!written) return messages_->showError(written.error());
    const bool isForNextStart =
        settings.language != before.language || settings.storeFolder != before.storeFolder ||
        settings.keepDays != before.keepDays || settings.modelCapMb != before.modelCapMb;
    if (isForNextStart)
        messages_->showNote(
            tr("The settings are saved. Language and sessions follow them from the next start."));
}

}  // namespace macula::viewer
