// The study of the window in a headset: begun, mirrored, and what was chosen there or here.
#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QStandardPaths>

#include "scene/clip/clip_of_shape.h"
#include "study/open/identity.h"
#include "viewer/headset/headset_mirror.h"
#include "viewer/headset/headset_show.h"
#include "viewer/language/core_words.h"
#include "viewer/window/main_window.h"

namespace macula::viewer {

void MainWindow::makeHeadset() {
    headset_ = new HeadsetShow(this);
    mirror_ = new HeadsetMirror;
    auto* dock = new QDockWidget(tr("Headset"), this);
    dock->setObjectName(QStringLiteral("headset-panel"));
    dock->setWidget(mirror_);
    dock->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable);
    addDockWidget(Qt::RightDockWidgetArea, dock);
    dock->hide();
    panels_ << dock->toggleViewAction();
    connect(mirror_, &HeadsetMirror::startAsked, this, &MainWindow::showInHeadset);
    connect(mirror_, &HeadsetMirror::stopAsked, headset_, &HeadsetShow::stop);
    connect(headset_, &HeadsetShow::began, this, [this, dock] {
        messages_->hide();
        mirror_->setRunning(true);
        mirror_->setNote(tr("Looking for the headset"));
        dock->show();
    });
    connect(headset_, &HeadsetShow::mirrored, this, [this](const QImage& leftEye) {
        mirror_->setPicture(leftEye);
        if (!std::exchange(isMirrored_, true)) mirror_->setNote({});
    });
    connect(headset_, &HeadsetShow::noted, mirror_, &HeadsetMirror::setNote);
    connect(headset_, &HeadsetShow::chosen, this, &MainWindow::takeFromHeadset);
    connect(headset_, &HeadsetShow::failed, this, [this](const Error& error) {
        messages_->showError(error);
        emit failed(error);
    });
    connect(headset_, &HeadsetShow::ended, this, [this](const QString& figures) {
        isMirrored_ = false;
        mirror_->setRunning(false);
        mirror_->setNote(figures);
        emit headsetEnded();
    });
    // Another study is no surprise for somebody's eyes.
    connect(&session_, &StudyEditor::studyShown, headset_, &HeadsetShow::abandon);
    connect(shown_, &ShownVolume::changed, this, [this] {
        if (!headset_->isRunning() || isFromHeadset_) return;
        const scene::Drawing drawing = shown_->drawing();
        headsetClip_ = drawing.clip;
        headset_->propose({.transferFunction = drawing.transferFunction, .clip = drawing.clip});
    });
    if (options_.showsInHeadset)
        connect(
            this, &MainWindow::studyShown, this, [this] { showInHeadset(); }, Qt::SingleShotConnection);
}

void MainWindow::addHeadsetAction(QMenu& view) {
    QAction* action = view.addAction(tr("Show in &Headset"), this, &MainWindow::showInHeadset);
    action->setObjectName(QStringLiteral("show-in-headset"));
    action->setToolTip(tr("This study in a headset (OpenXR), to be held, turned and cut by hand"));
}

void MainWindow::showInHeadset() {
    if (!hasPictureFor(tr("There is nothing to show in a headset yet."))) return;
    HeadsetShowRequest request;
    request.volume = study().volume;
    request.drawing = shown_->drawing();
    for (const auto& preset : catalogue().presets)
        if (suits(*preset, request.volume->unit())) request.presets.push_back(preset);
    request.pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation).toStdString();
    QStringList names;
    for (const std::string& line : study::linesOf(study().identity)) names << QString::fromStdString(line);
    mirror_->setNames(names.join(QLatin1Char('\n')));
    headsetClip_ = request.drawing.clip;
    headset_->start(std::move(request));
}

// One step of undo of the window, too. What cannot be kept with the study is seen in the headset alone.
void MainWindow::takeFromHeadset(const HeadsetSelection& choice) {
    if (!hasStudy() || !headset_->isRunning()) return;
    const bool isOtherClip = std::exchange(headsetClip_, choice.clip) != choice.clip;
    scene::OptionalClip clip = session_.state().clip;
    if (isOtherClip) {
        auto kept = scene::clipOfShape(choice.clip ? *choice.clip : Clip{}, clip, *study().volume);
        if (!kept) return messages_->showError(kept.error());
        clip = *std::move(kept);
    }
    isFromHeadset_ = true;
    session_.change(tr("In the headset"), [&](scene::StudyState& next) {
        next.preset = choice.transferFunction;
        if (!isOtherClip) return;
        next.clip = clip;
        next.cuts.eye.reset();  // it is among the planes of the clip now
    });
    isFromHeadset_ = false;
}

}  // namespace macula::viewer
