#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/watch/watch_controller.h"

#include <QDir>
#include <QMainWindow>
#include <QMenu>
#include <algorithm>
#include <filesystem>

#include "viewer/jobs/post.h"
#include "viewer/menus/controls.h"
#include "viewer/settings/file_dialogs.h"
#include "viewer/settings/settings.h"
#include "viewer/status/notifications.h"
#include "viewer/volume/opening_controller.h"
#include "viewer/watch/arrival_bar.h"

namespace macula::viewer {

namespace {

using Clock = study::WatchedFolder::Clock;

constexpr int kPauseTimesLook = 20;  // a look takes at most a twentieth of the time

}  // namespace

WatchController::WatchController(const WindowContext& context, OpeningController& opening,
                                 const QStringList& folders, WatchPace pace)
    : QObject(&context.window),
      context_(context),
      opening_(opening),
      pace_(pace),
      bar_(new ArrivalBar),
      look_(this, {.ended = [this](const Result<Looked>& looked) { take(looked); }}) {
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &WatchController::look);
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
    add->setEnabled(folders_.size() < kMostWatchedFolders);
    if (!folders_.isEmpty()) menu_->addSeparator();
    for (const QString& folder : folders_) {
        QString name = namesShown_ ? QDir(folder).dirName() : tr("a folder");
        if (absent_.contains(folder)) name = tr("%1 (cannot be read now)").arg(name);
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
    if (folders_.contains(folder))
        return context_.notifications.showNote(tr("This folder is watched already."));
    if (folders_.size() >= kMostWatchedFolders)
        return context_.notifications.refuse(tr("No more folders can be watched."),
                                             tr("Stop watching another one first."));
    begin(folder);
    fillMenu();
    Q_EMIT foldersChanged(folders_);
    context_.notifications.showNote(
        tr("Macula now says when a study appears in this folder. What is there already is not told."));
}

void WatchController::begin(const QString& folder) {
    if (folders_.contains(folder) || folders_.size() >= kMostWatchedFolders) return;
    folders_.append(folder);
    watched_.push_back(std::make_shared<study::WatchedFolder>(folder.toStdString(), pace_.quiet));
    if (!look_.running()) timer_.start(0);
}

// A menu must not destroy the action that called this.
void WatchController::stopWatching(const QString& folder) {
    const std::filesystem::path path = folder.toStdString();
    folders_.removeAll(folder);
    std::erase_if(watched_, [&](const auto& each) { return each->folder() == path; });
    bar_->dropFolder(path);
    post(this, [this] { fillMenu(); });
    Q_EMIT foldersChanged(folders_);
}

void WatchController::look() {
    if (watched_.empty() || look_.running()) return;
    look_.start([watched = watched_](Progress& progress) -> Result<Looked> {
        const Clock::time_point begun = Clock::now();
        Looked looked;
        for (const auto& folder : watched) {
            if (progress.cancelled()) break;
            auto arrived = folder->look(Clock::now(), progress);
            if (!arrived) {
                if (arrived.error().code != ErrorCode::cancelled)
                    looked.absent.append(QString::fromStdString(folder->folder().string()));
                continue;
            }
            looked.arrived.insert(looked.arrived.end(), arrived->begin(), arrived->end());
        }
        looked.took = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - begun);
        return looked;
    });
}

void WatchController::take(const Result<Looked>& looked) {
    ++looks_;
    timer_.start(looked ? std::max(pace_.every, kPauseTimesLook * looked->took) : pace_.every);
    if (!looked) return;
    if (absent_ != looked->absent) {
        absent_ = looked->absent;
        fillMenu();
    }
    for (const study::ArrivedStudy& study : looked->arrived) {
        // The look began before a person stopped watching the folder.
        if (folders_.contains(QString::fromStdString(study.folder.string()))) bar_->add(study);
    }
}

}  // namespace macula::viewer
