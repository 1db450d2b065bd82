// The model behind all panels: the open study and all choices for it, as one immutable value that each change
// replaces.
#pragma once

#include <QObject>
#include <QString>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>

#include "scene/choice/catalogue.h"
#include "scene/state/study_state.h"
#include "study/open/opened_study.h"
#include "viewer/editor/state_history.h"

namespace macula::viewer {

// Panels read state(), and propose a changed one:
//
//     session.change(tr("Preset"), [&](scene::StudyState& next) { next.preset = chosen; });
//
// Views of the state listen to `changed`. Nothing here draws or blocks. Lives on the UI thread.
class StudyEditor : public QObject {
    Q_OBJECT

  public:
    explicit StudyEditor(scene::Catalogue catalogue, QObject* parent = nullptr);

    const scene::Catalogue& catalogue() const { return catalogue_; }
    // Appends the person's own presets to the built-in ones in the catalogue.
    void setOwnPresets(std::span<const std::shared_ptr<const TransferFunction>> own);
    std::span<const std::shared_ptr<const TransferFunction>> builtInPresets() const;
    bool hasStudy() const { return study_.volume != nullptr; }
    const study::OpenedStudy& study() const { return study_; }  // its volume is null before the first study
    const scene::StudyState& state() const { return history_.now(); }

    // Whether the study replaced another volume on the same grid (study::staysInPlace), so that panes keep
    // their view.
    bool keepsPlace() const { return keepsPlace_; }

    // Replaces the study, in this state, and clears the undo history.
    void show(study::OpenedStudy study, scene::StudyState state);
    // The same with the default state: the preset of its modality.
    void show(study::OpenedStudy study);

    using Edit = std::function<void(scene::StudyState&)>;
    // One undo step; `what` names it for the menu: "Preset". An edit without effect makes no step.
    void change(const QString& what, const Edit& edit);
    // The same during a drag: all edits until `endDrag` or another `what` are one step.
    void drag(const QString& what, const Edit& edit);
    void endDrag();
    // A change that follows from something else, such as the camera: it makes no undo step.
    void follow(const Edit& edit);
    // Removes a choice that failed: `edit` takes it out of all steps, and steps left without a change are
    // dropped.
    void correct(const Edit& edit);

    bool canUndo() const { return history_.canUndo(); }
    bool canRedo() const { return history_.canRedo(); }
    QString undoText() const { return history_.undoText(); }  // the step to undo; empty: none
    QString redoText() const { return history_.redoText(); }
    void undo();
    void redo();

  Q_SIGNALS:
    void studyShown();  // another study, with its state
    // A change of the same study's state. `before` is valid during the signal.
    void changed(const macula::scene::StudyState& before);
    void presetsChanged();  // the catalogue has other presets

  private:
    void push(const QString& what, const Edit& edit, bool joins);
    void tellOfChange(const std::function<bool()>& change);

    scene::Catalogue catalogue_;
    std::size_t builtInPresets_ = 0;  // how many: they come first in the catalogue
    study::OpenedStudy study_;
    bool keepsPlace_ = false;
    StateHistory history_;
};

// Calls `show` at once, and again for each other state or study as long as `shown` lives.
template <class Show>
void followState(StudyEditor& session, QObject* shown, Show show) {
    QObject::connect(&session, &StudyEditor::changed, shown, show);
    QObject::connect(&session, &StudyEditor::studyShown, shown, show);
    show();
}

}  // namespace macula::viewer
