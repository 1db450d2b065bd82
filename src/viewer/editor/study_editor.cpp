#include "viewer/editor/study_editor.h"

#include <utility>

#include "scene/state/carried_view.h"
#include "study/open/same_place.h"

namespace macula::viewer {

StudyEditor::StudyEditor(scene::Catalogue catalogue, QObject* parent)
    : QObject(parent), catalogue_(std::move(catalogue)), builtInPresets_(catalogue_.presets.size()) {}

void StudyEditor::setOwnPresets(std::span<const std::shared_ptr<const TransferFunction>> own) {
    catalogue_.presets.resize(builtInPresets_);
    catalogue_.presets.insert(catalogue_.presets.end(), own.begin(), own.end());
    Q_EMIT presetsChanged();
}

std::span<const std::shared_ptr<const TransferFunction>> StudyEditor::builtInPresets() const {
    return std::span(catalogue_.presets).first(builtInPresets_);
}

void StudyEditor::show(study::OpenedStudy study, scene::StudyState state) {
    keepsPlace_ = study::staysInPlace(study_, study);
    study_ = std::move(study);
    history_.begin(std::move(state));
    Q_EMIT studyShown();
}

void StudyEditor::show(study::OpenedStudy study) {
    scene::StudyState state;
    state.seriesDigest = study.seriesDigest;
    if (study.volume) state.preset = scene::presetFor(catalogue_, *study.volume);
    show(std::move(study), std::move(state));
}

void StudyEditor::change(const QString& what, const Edit& edit) {
    push(what, edit, false);
}

void StudyEditor::drag(const QString& what, const Edit& edit) {
    push(what, edit, true);
}

void StudyEditor::endDrag() {
    history_.endJoining();
}

void StudyEditor::follow(const Edit& edit) {
    scene::StudyState next = state();
    edit(next);
    tellOfChange([&] { return history_.amend(std::move(next)); });
}

void StudyEditor::correct(const Edit& edit) {
    tellOfChange([&] { return history_.correct(edit); });
}

void StudyEditor::push(const QString& what, const Edit& edit, bool joins) {
    scene::StudyState next = state();
    edit(next);
    tellOfChange([&] { return history_.push(what, std::move(next), joins); });
}

void StudyEditor::undo() {
    if (!canUndo()) return;
    tellOfChange([&] { return history_.undo(), true; });
}

void StudyEditor::redo() {
    if (!canRedo()) return;
    tellOfChange([&] { return history_.redo(), true; });
}

// Copies the state: a listener may change it again, and `before` must stay the same meanwhile.
void StudyEditor::tellOfChange(const std::function<bool()>& change) {
    const scene::StudyState before = state();
    if (change()) Q_EMIT changed(before);
}

}  // namespace macula::viewer
