// Where file dialogs begin.
#pragma once

#include <QMap>
#include <QString>
#include <QStringList>
#include <utility>

namespace macula::viewer {

// What a dialog is about.
enum class FolderKind { studies, pictures, movies, models, views, presets, measurements, presentations };

// Remembers, for each kind by itself, the folder that was used last. Of studies the folder of one may be
// named for its patient: what is kept between runs is the folder that such a folder lies in.
class LastFolders {
  public:
    // `kept`: toKeep() of an earlier run. What is no name of a kind stays as it is.
    explicit LastFolders(QMap<QString, QString> kept = {}) : kept_(std::move(kept)) {}

    // Where a dialog begins: the folder of its kind that was used last, and is still there; else one of the
    // person's own, such as that for pictures. Never the working directory.
    QString of(FolderKind kind) const;
    // A dialog has ended in that folder.
    void use(FolderKind kind, const QString& folder);
    // A study was opened from there, a folder or a file.
    void sawStudy(const QString& path);

    const QMap<QString, QString>& toKeep() const { return kept_; }

  private:
    QString beside(const QString& folder) const;  // studies, where it lies in one

    QMap<FolderKind, QString> used_;  // in this run
    QMap<QString, QString> kept_;
    QStringList studies_;  // folders of theirs
};

}  // namespace macula::viewer
