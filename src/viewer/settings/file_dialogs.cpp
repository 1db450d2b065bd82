#include "viewer/settings/file_dialogs.h"

#include <QDir>
#include <utility>

namespace macula::viewer {

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
