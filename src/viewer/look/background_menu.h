// The menu of background colours of the 3D picture.
#pragma once

#include <optional>

#include "scene/lights/background_colour.h"
#include "viewer/editor/study_editor.h"
#include "viewer/menus/choice_menu.h"

namespace macula::viewer {

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

}  // namespace macula::viewer
