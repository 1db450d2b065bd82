// The Look menu: how the volume is drawn, the filter between voxels, and the display window.
#pragma once

#include <QObject>

#include "viewer/context/window_context.h"

class QAction;
class QMenuBar;

namespace macula::viewer {

class ChoiceMenu;

// Lives on the UI thread.
class LookController : public QObject {
    Q_OBJECT

  public:
    explicit LookController(const WindowContext& context);

    void addMenu(QMenuBar& bar);

  private:
    void addShading();
    void addFilters();
    void addToneMap();
    void addWindow();
    void showChosen();  // checks the session's choices in the menu
    void showUsable();

    WindowContext context_;
    ChoiceMenu* menu_ = nullptr;
    QAction* shading_ = nullptr;
    QAction* resetWindow_ = nullptr;
};

}  // namespace macula::viewer
