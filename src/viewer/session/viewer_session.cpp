#include "viewer/session/viewer_session.h"

#include <utility>

#include "scene/state/carried_view.h"
#include "study/open/same_place.h"

namespace macula::viewer {

ViewerSession::ViewerSession(app::Catalogue catalogue, QObject* parent)
    : QObject(parent), catalogue_(std::move(catalogue)), builtInPresets_(catalogue_.presets.size()) {}

void ViewerSession::setOwnPresets(std::span<const std::shared_ptr<const TransferFunction>> own) {
    catalogue_.presets.resize(builtInPresets_);
    catalogue_.presets.insert(catalogue_.presets.end(), own.begin(), own.end());
    emit presetsChanged();
}

std::span<const std::shared_ptr<const TransferFunction>> ViewerSession::builtInPresets() const {
    return std::span(catalogue_.presets).first(builtInPresets_);
}

void ViewerSession::show(app::OpenedStudy study, app::StudyState state) {
    keepsPlace_ = app::staysInPlace(study_, study);
    study_ = std::move(study);
    history_.begin(std::move(state));
    emit studyShown();
}

void ViewerSession::show(app::OpenedStudy study) {
    app::StudyState state;
    state.seriesDigest = study.seriesDigest;
    if (study.volume) state.preset = app::presetFor(catalogue_, *study.volume);
    show(std::move(study), std::move(state));
}

void ViewerSession::change(const QString& what, const Edit& edit) {
    push(what, edit, false);
}

void ViewerSession::drag(const QString& what, const Edit& edit) {
    push(what, edit, true);
}

void ViewerSession::endDrag() {
    history_.endJoining();
}

void ViewerSession::follow(const Edit& edit) {
    app::StudyState next = state();
    edit(next);
    tellOfChange([&] { return history_.amend(std::move(next)); });
}

void ViewerSession::correct(const Edit& edit) {
    tellOfChange([&] { return history_.correct(edit); });
}

void ViewerSession::push(const QString& what, const Edit& edit, bool joins) {
    app::StudyState next = state();
    edit(next);
    tellOfChange([&] { return history_.push(what, std::move(next), joins); });
}

void ViewerSession::undo() {
    if (!canUndo()) return;
    tellOfChange([&] { return history_.undo(), true; });
}

void ViewerSession::redo() {
    if (!canRedo()) return;
    tellOfChange([&] { return history_.redo(), true; });
}

// A listener may propose a change of its own: what it is told as `before` stays as it is.
void ViewerSession::tellOfChange(const std::function<bool()>& change) {
    const app::StudyState before = state();
    if (change()) emit changed(before);
}

}  // namespace macula::viewer
