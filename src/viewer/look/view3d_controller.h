// The 3D view: menu entries for its camera, marks and rays, and drags that edit the transfer function.
#pragma once

#include <QObject>
#include <QString>
#include <optional>

#include "scene/lights/background_colour.h"
#include "viewer/context/window_context.h"
#include "viewer/editor/study_editor.h"
#include "viewer/menus/choice_menu.h"

class QMenu;

namespace macula::viewer {

class TransferFunctionEditor;

// Edits the session's background, which can be undone: nearly black (the default), black, grey, white, or a
// picked colour. Lives on the UI thread; the session outlives it.
class BackgroundMenu : public ChoiceMenu {
    Q_OBJECT

  public:
    BackgroundMenu(StudyEditor& session, QWidget* parent);

  private:
    void onChosen(int index);
    void askForColour();
    void use(std::optional<scene::BackgroundColour> colour);
    void showChosen();

    StudyEditor& session_;
};

// Keys of its actions are handled by the viewport, so that they do nothing while a list has the focus. Lives
// on the UI thread.
class View3dController : public QObject {
    Q_OBJECT

  public:
    // `transfer` lives until the window's destructor.
    View3dController(const WindowContext& context, const TransferFunctionEditor& transfer);

    void redraw();                // after a choice was changed in the same study
    void addCamera(QMenu& view);  // standard views, and "Fit what is visible"
    void addMarks(QMenu& view);
    void addGaze(QMenu& view);

  private:
    WindowContext context_;
};

}  // namespace macula::viewer
