// Asks for the names under which presets are kept, copied and renamed.
#pragma once

#include <QObject>
#include <QString>
#include <functional>

#include "scene/state/study_state.h"
#include "viewer/editor/study_editor.h"
#include "viewer/presets/preset_library.h"

class QWidget;

namespace macula::viewer {

// What is saved is what is shown now, whatever is shown when a name was found. Dialogs do not block.
class PresetNaming : public QObject {
    Q_OBJECT

  public:
    // Returns the current state with its camera.
    using StateNow = std::function<scene::StudyState()>;

    // Dialogs are those of the window of `widget`; that, session and library outlive this.
    PresetNaming(QWidget& widget, const StudyEditor& session, PresetLibrary& library, StateNow stateNow);

    void askToSaveCurve();
    void askToSaveSeen();
    void askToCopy(const LibraryPreset& preset);
    void askToRename(const LibraryPreset& preset);

  Q_SIGNALS:
    void named();  // a person gave a name, before what follows from it
    void done();
    void failed(const macula::Error& error);

  private:
    using Then = std::function<Result<void>(const QString& name)>;
    void ask(const QString& title, const QString& what, const QString& proposed, const live::PresetRef& own,
             Then then);

    QWidget& widget_;
    const StudyEditor& session_;
    PresetLibrary& library_;
    StateNow stateNow_;
};

}  // namespace macula::viewer
