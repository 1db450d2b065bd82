// What is double-clicked in 3D is where the slices go, and what the camera turns around.
#pragma once

#include <QObject>

#include "viewer/context/window_context.h"

namespace macula::viewer {

class AnatomyPick;
class ScissorTool;

// Lives on the UI thread.
class PickController : public QObject {
    Q_OBJECT

  public:
    // The scissors, which take clicks while they are out, outlive it.
    PickController(const WindowContext& context, const ScissorTool& scissors);

    void cancel();

  private:
    WindowContext context_;
    AnatomyPick* pick_;
};

}  // namespace macula::viewer
