// The file dialogs of a window, each of which begins where the last of its kind ended.
#pragma once

#include <QFileDialog>
#include <QMap>
#include <QObject>
#include <QString>
#include <QStringList>
#include <functional>
#include <utility>

namespace macula::viewer {

// The kind of files of a dialog.
enum class FolderKind { studies, pictures, movies, models, views, presets, measurements, presentations };

// Remembers the last folder of each kind. The folder of a study may be named after its patient, so its parent
// folder is kept between runs instead.
class LastFolders {
  public:
    // `kept`: toKeep() of an earlier run. Unknown kinds stay as they are.
    explicit LastFolders(QMap<QString, QString> kept = {}) : kept_(std::move(kept)) {}

    // The start folder: the last one of its kind that still exists, else a standard folder such as Pictures.
    // Never the working directory.
    QString of(FolderKind kind) const;
    // Records the folder in which a dialog ended.
    void use(FolderKind kind, const QString& folder);
    // Records the folder or file from which a study was opened.
    void sawStudy(const QString& path);

    const QMap<QString, QString>& toKeep() const { return kept_; }

  private:
    QString beside(const QString& folder) const;  // the nearest folder outside all studies

    QMap<FolderKind, QString> used_;  // in this run
    QMap<QString, QString> kept_;
    QStringList studies_;  // folders of studies
};

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
    void sawStudy(const QString& path);

  Q_SIGNALS:
    void aboutToOpen();  // to end a drag: the dialog gets the button's release
    void foldersChanged(const QMap<QString, QString>& toKeep);

  private:
    QWidget& window_;
    LastFolders folders_;
};

}  // namespace macula::viewer
