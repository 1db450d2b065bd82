// What every panel looks at: the study that is open, and all that was chosen for it, as one value that is
// never changed, only followed by another.
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
#include "viewer/session/state_history.h"

namespace macula::viewer {

// Panels read state(), and propose another one:
//
//     session.change(tr("Preset"), [&](app::StudyState& next) { next.preset = chosen; });
//
// Who shows something of it listens to `changed`. Nothing here draws, and nothing waits. Lives on the UI
// thread.
class ViewerSession : public QObject {
    Q_OBJECT

  public:
    explicit ViewerSession(app::Catalogue catalogue, QObject* parent = nullptr);

    const app::Catalogue& catalogue() const { return catalogue_; }
    // The presets that a person owns stand in the catalogue behind the built-in ones.
    void setOwnPresets(std::span<const std::shared_ptr<const TransferFunction>> own);
    std::span<const std::shared_ptr<const TransferFunction>> builtInPresets() const;
    bool hasStudy() const { return study_.volume != nullptr; }
    const app::OpenedStudy& study() const { return study_; }  // its volume is null before the first
    const app::StudyState& state() const { return history_.now(); }

    // Whether the study that is shown came after another volume of the same place (app::staysInPlace), which
    // panes go on looking at.
    bool keepsPlace() const { return keepsPlace_; }

    // A study takes the place of the one before, in this state; there is nothing to undo.
    void show(app::OpenedStudy study, app::StudyState state);
    // The same as when nobody has seen it: with the preset of its modality.
    void show(app::OpenedStudy study);

    using Edit = std::function<void(app::StudyState&)>;
    // One step, `what` in a word or two for the menu: "Preset". Nothing happens where the edit changes
    // nothing.
    void change(const QString& what, const Edit& edit);
    // The same while a hand moves: until `endDrag`, or a change of something else, all is one step.
    void drag(const QString& what, const Edit& edit);
    void endDrag();
    // What comes of itself, such as of the camera, which is no part of what can be undone: no step.
    void follow(const Edit& edit);
    // What was asked for and is not to be had: `edit` takes it out of all steps, and who made a step of
    // nothing else has made none.
    void correct(const Edit& edit);

    bool canUndo() const { return history_.canUndo(); }
    bool canRedo() const { return history_.canRedo(); }
    QString undoText() const { return history_.undoText(); }  // what would be undone; empty: nothing
    QString redoText() const { return history_.redoText(); }
    void undo();
    void redo();

  signals:
    void studyShown();  // another one, with its state
    // Of the same study. `before` is valid while the signal is told.
    void changed(const macula::app::StudyState& before);
    void presetsChanged();  // those of the catalogue

  private:
    void push(const QString& what, const Edit& edit, bool joins);
    void tellOfChange(const std::function<bool()>& change);

    app::Catalogue catalogue_;
    std::size_t builtInPresets_ = 0;  // the first so many of the catalogue
    app::OpenedStudy study_;
    bool keepsPlace_ = false;
    StateHistory history_;
};

}  // namespace macula::viewer
