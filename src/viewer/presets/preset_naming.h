// Asks for the names under which presets are kept, copied and renamed.
#pragma once

#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QObject>
#include <QPushButton>
#include <QString>
#include <functional>

#include "scene/state/study_state.h"
#include "viewer/editor/study_editor.h"
#include "viewer/presets/preset_library.h"

class QWidget;

namespace macula::viewer {

// Asks for the name of a preset. Accepts only an allowed name, and says why another is refused. Open it with
// open(), which does not block.
class PresetNameDialog : public QDialog {
    Q_OBJECT

  public:
    // Returns an empty text for an allowed name.
    using WhyRefused = std::function<QString(const QString&)>;

    PresetNameDialog(const QString& title, const QString& what, const QString& proposed,
                     WhyRefused whyRefused, QWidget* parent = nullptr);

    QString name() const { return name_->text(); }

  private:
    void check();

    WhyRefused whyRefused_;
    QLineEdit* name_;
    QLabel* trouble_;
    QPushButton* ok_ = nullptr;
};

// Saves what was shown when the dialog opened, even if something else is shown once a name is chosen. Dialogs
// do not block.
class PresetNaming : public QObject {
    Q_OBJECT

  public:
    // Returns the current state with its camera.
    using StateNow = std::function<scene::StudyState()>;

    // Dialogs belong to the window of `widget`. `widget`, session and library outlive this.
    PresetNaming(QWidget& widget, const StudyEditor& session, PresetLibrary& library, StateNow stateNow);

    void askToSaveCurve();
    void askToSaveSeen();
    void askToCopy(const LibraryPreset& preset);
    void askToRename(const LibraryPreset& preset);

  Q_SIGNALS:
    void named();  // a person gave a name, which is not used yet
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
