// A double click in 3D moves the slices to the anatomy there, and makes the camera turn around it.
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
    // `scissors` outlives it, and takes clicks while the scissors are out.
    PickController(const WindowContext& context, const ScissorTool& scissors);

    void cancel();

  private:
    WindowContext context_;
    AnatomyPick* pick_;
};

}  // namespace macula::viewer
