// The file dialogs of a window, each of which begins where the last of its kind ended.
#pragma once

#include <QFileDialog>
#include <QMap>
#include <QObject>
#include <QString>
#include <functional>

#include "viewer/settings/last_folders.h"

namespace macula::viewer {

// The window outlives it. Lives on the UI thread.
class FileDialogs : public QObject {
    Q_OBJECT

  public:
    // `kept`: the folders of an earlier run, see LastFolders.
    FileDialogs(QWidget& window, QMap<QString, QString> kept);

    // A dialog for `ask`; without a filter for all files.
    QFileDialog* toOpen(FolderKind kind, const QString& title, const QString& filter = {}) const;
    QFileDialog* toOpenFolder(FolderKind kind, const QString& title) const;
    QFileDialog* toSave(FolderKind kind, const QString& title, const QString& filter, const QString& suffix,
                        const QString& name) const;
    // Files get the suffix of the filter that is chosen, "Table (*.csv)".
    static void followFilter(QFileDialog& dialog);

    // Opens the dialog and returns at once; `then` gets the file or folder that was chosen.
    void ask(QFileDialog* dialog, FolderKind kind, std::function<void(const QString&)> then);
    QString folderOf(FolderKind kind) const { return folders_.of(kind); }
    void sawStudy(const QString& path);

  Q_SIGNALS:
    void aboutToOpen();  // to end a drag: the dialog gets the button's release
    void foldersChanged(const QMap<QString, QString>& toKeep);

  private:
    QWidget& window_;
    LastFolders folders_;
};

}  // namespace macula::viewer
