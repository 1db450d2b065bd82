#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/watch/watch_controller.h"

#include <QDir>
#include <QMainWindow>
#include <QMenu>
#include <algorithm>
#include <limits>

#include "viewer/jobs/post.h"
#include "viewer/menus/controls.h"
#include "viewer/settings/file_dialogs.h"
#include "viewer/settings/settings.h"
#include "viewer/status/notifications.h"
#include "viewer/volume/opening_controller.h"
#include "viewer/watch/arrival_bar.h"

namespace macula::viewer {

WatchController::WatchController(const WindowContext& context, OpeningController& opening,
                                 const QStringList& folders, WatchPace pace)
    : QObject(&context.window), context_(context), opening_(opening), pace_(pace), bar_(new ArrivalBar) {
    connect(bar_, &ArrivalBar::openAsked, this,
            [this](const study::ArrivedStudy& study) { opening_.open(study.file); });
    for (const QString& folder : folders) begin(folder);
}

void WatchController::addMenu(QMenu& file) {
    menu_ = file.addMenu(tr("&Watched Folders"));
    menu_->setToolTipsVisible(true);
    fillMenu();
}

void WatchController::fillMenu() {
    if (menu_ == nullptr) return;
    menu_->clear();
    QAction* add = menu_->addAction(tr("&Watch a Folder…"), this, &WatchController::askForFolder);
    describe(*add, "watch-add", tr("Say when a study appears in a folder; nothing is opened by itself"));
    add->setEnabled(looks_.size() < kMostWatchedFolders);
    if (!looks_.empty()) menu_->addSeparator();
    for (const FolderLook* look : looks_) {
        const QString& folder = look->folder();
        QString name = namesShown_ ? QDir(folder).dirName() : tr("a folder");
        if (look->isAbsent()) name = tr("%1 (cannot be read now)").arg(name);
        QAction* stop =
            menu_->addAction(tr("Stop Watching %1").arg(name.replace(QLatin1Char('&'), QStringLiteral("&&"))),
                             this, [this, folder] { stopWatching(folder); });
        describe(*stop, "watch-stop", namesShown_ ? folder : QString());
    }
}

void WatchController::showNames(bool shown) {
    namesShown_ = shown;
    bar_->showNames(shown);
    fillMenu();
}

void WatchController::askForFolder() {
    auto* dialog = context_.files.toOpenFolder(FolderKind::studies, tr("Choose a folder to watch"));
    context_.files.ask(dialog, FolderKind::studies, [this](const QString& path) { watch(path); });
}

void WatchController::watch(const QString& path) {
    const QString folder = QDir(path).absolutePath();
    if (folders().contains(folder))
        return context_.notifications.showNote(tr("This folder is watched already."));
    if (looks_.size() >= kMostWatchedFolders)
        return context_.notifications.refuse(tr("No more folders can be watched."),
                                             tr("Stop watching another one first."));
    begin(folder);
    fillMenu();
    Q_EMIT foldersChanged(folders());
    context_.notifications.showNote(
        tr("Macula now says when a study appears in this folder. What is there already is not told."));
}

void WatchController::begin(const QString& folder) {
    if (folders().contains(folder) || looks_.size() >= kMostWatchedFolders) return;
    auto* look = new FolderLook(folder, pace_, this);
    looks_.push_back(look);
    connect(look, &FolderLook::arrived, bar_, &ArrivalBar::add);
    connect(look, &FolderLook::absenceChanged, this, &WatchController::fillMenu);
}

// A menu must not destroy the action that called this.
void WatchController::stopWatching(const QString& folder) {
    const auto stopped = std::ranges::find(looks_, folder, &FolderLook::folder);
    if (stopped == looks_.end()) return;
    delete *stopped;
    looks_.erase(stopped);
    bar_->dropFolder(folder.toStdString());
    post(this, [this] { fillMenu(); });
    Q_EMIT foldersChanged(folders());
}

QStringList WatchController::folders() const {
    QStringList folders;
    for (const FolderLook* look : looks_) folders.append(look->folder());
    return folders;
}

std::size_t WatchController::looks() const {
    std::size_t least = std::numeric_limits<std::size_t>::max();
    for (const FolderLook* look : looks_) least = std::min(least, look->looks());
    return least;
}

}  // namespace macula::viewer
