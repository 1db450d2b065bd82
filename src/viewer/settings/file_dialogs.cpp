#include "viewer/settings/file_dialogs.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <array>
#include <utility>

namespace macula::viewer {

namespace {

// Of each FolderKind, as settings keep them.
constexpr std::array kNames{"studies", "pictures", "movies",       "models",
                            "views",   "presets",  "measurements", "presentations"};
static_assert(kNames.size() == std::size_t(FolderKind::presentations) + 1);

QString nameOf(FolderKind kind) {
    return QString::fromLatin1(kNames.at(std::size_t(kind)));
}

QString ownFolder(FolderKind kind) {
    const auto place = kind == FolderKind::pictures  ? QStandardPaths::PicturesLocation
                       : kind == FolderKind::movies  ? QStandardPaths::MoviesLocation
                       : kind == FolderKind::studies ? QStandardPaths::HomeLocation
                                                     : QStandardPaths::DocumentsLocation;
    const QString folder = QStandardPaths::writableLocation(place);
    return !folder.isEmpty() && QFileInfo(folder).isDir() ? folder : QDir::homePath();
}

bool isIn(const QString& path, const QString& folder) {
    return path == folder ||
           path.startsWith(folder == QLatin1String("/") ? folder : folder + QLatin1Char('/'));
}

QString above(const QString& folder) {
    return QFileInfo(folder).absolutePath();
}

}  // namespace

QString LastFolders::of(FolderKind kind) const {
    for (const QString& folder : {used_.value(kind), kept_.value(nameOf(kind))})
        if (!folder.isEmpty() && QFileInfo(folder).isDir()) return folder;
    return ownFolder(kind);
}

void LastFolders::use(FolderKind kind, const QString& folder) {
    const QString clean = QDir::cleanPath(QFileInfo(folder).absoluteFilePath());
    used_[kind] = clean;
    if (kind != FolderKind::studies) kept_[nameOf(kind)] = beside(clean);
}

void LastFolders::sawStudy(const QString& path) {
    const QFileInfo opened(path);
    const QString folder =
        QDir::cleanPath(opened.isDir() ? opened.absoluteFilePath() : opened.absolutePath());
    if (!studies_.contains(folder)) studies_ << folder;
    kept_[nameOf(FolderKind::studies)] = above(folder);
    // Also replaces kept folders inside the new study: a person may have saved there before it was known to
    // hold one.
    for (QString& each : kept_) each = beside(each);
}

QString LastFolders::beside(const QString& folder) const {
    QString outside = folder;
    for (bool isMoved = true; isMoved;) {
        isMoved = false;
        for (const QString& study : studies_) {
            if (!isIn(outside, study) || study == above(study)) continue;
            outside = above(study);
            isMoved = true;
        }
    }
    return outside;
}

FileDialogs::FileDialogs(QWidget& window, QMap<QString, QString> kept)
    : QObject(&window), window_(window), folders_(std::move(kept)) {}

QFileDialog* FileDialogs::toOpen(FolderKind kind, const QString& title, const QString& filter) const {
    auto* dialog = new QFileDialog(&window_, title, folders_.of(kind), filter);
    dialog->setFileMode(QFileDialog::ExistingFile);
    return dialog;
}

QFileDialog* FileDialogs::toOpenFolder(FolderKind kind, const QString& title) const {
    auto* dialog = new QFileDialog(&window_, title, folders_.of(kind));
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    return dialog;
}

QFileDialog* FileDialogs::toSave(FolderKind kind, const QString& title, const QString& filter,
                                 const QString& suffix, const QString& name) const {
    auto* dialog = new QFileDialog(&window_, title, folders_.of(kind), filter);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(suffix);
    dialog->selectFile(name);
    return dialog;
}

void FileDialogs::followFilter(QFileDialog& dialog) {
    connect(&dialog, &QFileDialog::filterSelected, &dialog, [&dialog](const QString& filter) {
        dialog.setDefaultSuffix(filter.section(QLatin1String("*."), 1).chopped(1));
    });
}

void FileDialogs::ask(QFileDialog* dialog, FolderKind kind, std::function<void(const QString&)> then) {
    Q_EMIT aboutToOpen();
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QFileDialog::fileSelected, this,
            [this, dialog, kind, then = std::move(then)](const QString& path) {
                folders_.use(kind, dialog->directory().absolutePath());
                Q_EMIT foldersChanged(folders_.toKeep());
                then(path);
            });
    dialog->open();  // exec() would run a second event loop
}

void FileDialogs::sawStudy(const QString& path) {
    folders_.sawStudy(path);
    Q_EMIT foldersChanged(folders_.toKeep());
}

}  // namespace macula::viewer
