#include "viewer/headset/headset_controller.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QStandardPaths>
#include <utility>

#include "scene/clip/clip_of_shape.h"
#include "study/open/identity.h"
#include "viewer/editor/study_editor.h"
#include "viewer/headset/headset_mirror.h"
#include "viewer/headset/headset_show.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/status/notifications.h"
#include "viewer/volume/shown_volume.h"

namespace macula::viewer {

HeadsetController::HeadsetController(const WindowContext& context)
    : QObject(&context.window), context_(context), show_(new HeadsetShow(this)), mirror_(new HeadsetMirror) {
    connect(mirror_, &HeadsetMirror::startAsked, this, &HeadsetController::begin);
    connect(mirror_, &HeadsetMirror::stopAsked, show_, &HeadsetShow::stop);
    connectShow();
    // Never replaces the study in front of a person's eyes: the headset's session ends instead.
    connect(&context_.session, &StudyEditor::studyShown, show_, &HeadsetShow::abandon);
    connect(&context_.shown, &ShownVolume::changed, this, [this] {
        if (!show_->isRunning() || isFromHeadset_) return;
        const scene::Drawing drawing = context_.shown.drawing();
        clip_ = drawing.clip;
        show_->propose({.transferFunction = drawing.transferFunction, .clip = drawing.clip});
    });
}

void HeadsetController::connectShow() {
    connect(show_, &HeadsetShow::began, this, [this] {
        context_.notifications.hide();
        mirror_->setRunning(true);
        mirror_->setNote(tr("Looking for the headset"));
    });
    connect(show_, &HeadsetShow::mirrored, this, [this](const QImage& leftEye) {
        mirror_->setPicture(leftEye);
        if (!std::exchange(isMirrored_, true)) mirror_->setNote({});
    });
    connect(show_, &HeadsetShow::noted, mirror_, &HeadsetMirror::setNote);
    connect(show_, &HeadsetShow::chosen, this, &HeadsetController::take);
    connect(show_, &HeadsetShow::failed, this,
            [this](const Error& error) { context_.notifications.fail(error); });
    connect(show_, &HeadsetShow::ended, this, [this](const QString& figures) {
        isMirrored_ = false;
        mirror_->setRunning(false);
        mirror_->setNote(figures);
        Q_EMIT ended();
    });
}

void HeadsetController::setDock(QDockWidget& dock) {
    connect(show_, &HeadsetShow::began, &dock, &QWidget::show);
}

void HeadsetController::addAction(QMenu& view) {
    QAction* action = view.addAction(tr("Show in &Headset"), this, &HeadsetController::begin);
    describe(*action, "show-in-headset",
             tr("This study in a headset (OpenXR), to be held, turned and cut by hand"));
}

void HeadsetController::begin() {
    const StudyEditor& session = context_.session;
    if (!context_.notifications.refuseUnless(session.hasStudy(),
                                             tr("There is nothing to show in a headset yet.")))
        return;
    HeadsetShowRequest request;
    request.volume = session.study().volume;
    request.drawing = context_.shown.drawing();
    for (const auto& preset : session.catalogue().presets)
        if (suits(*preset, request.volume->unit())) request.presets.push_back(preset);
    request.pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation).toStdString();
    mirror_->setNames(inWindowsLanguage(study::linesOf(session.study().identity)).join(QLatin1Char('\n')));
    clip_ = request.drawing.clip;
    show_->start(std::move(request));
}

// One undo step of the window, too. A choice that the study state cannot hold shows in the headset only.
void HeadsetController::take(const HeadsetSelection& choice) {
    if (!context_.session.hasStudy() || !show_->isRunning()) return;
    const bool isOtherClip = std::exchange(clip_, choice.clip) != choice.clip;
    scene::OptionalClip clip = context_.session.state().clip;
    if (isOtherClip) {
        auto kept =
            scene::clipOfShape(choice.clip ? *choice.clip : Clip{}, clip, *context_.session.study().volume);
        if (!kept) return context_.notifications.showError(kept.error());
        clip = *std::move(kept);
    }
    isFromHeadset_ = true;
    context_.session.change(tr("In the headset"), [&](scene::StudyState& next) {
        next.preset = choice.transferFunction;
        if (!isOtherClip) return;
        next.clip = clip;
        next.cuts.eye.reset();  // the clip includes this plane now
    });
    isFromHeadset_ = false;
}

}  // namespace macula::viewer
