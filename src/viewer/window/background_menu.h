// What lies behind the patient in the 3D picture.
#pragma once

#include <optional>

#include "scene/lights/background_colour.h"
#include "viewer/session/viewer_session.h"
#include "viewer/window/choice_menu.h"

namespace macula::viewer {

// The choice of the session, which can be undone: nearly black as when nobody chose, black, grey, white, or a
// colour that a person picks. Lives on the UI thread, as long as the session at most.
class BackgroundMenu : public ChoiceMenu {
    Q_OBJECT

  public:
    BackgroundMenu(ViewerSession& session, QWidget* parent);

  private:
    void onChosen(int index);
    void askForColour();
    void use(std::optional<app::BackgroundColour> colour);
    void showChosen();

    ViewerSession& session_;
};

}  // namespace macula::viewer
