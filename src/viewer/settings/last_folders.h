// The start folders of file dialogs.
#pragma once

#include <QMap>
#include <QString>
#include <QStringList>
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

}  // namespace macula::viewer
