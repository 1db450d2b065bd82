// The native window of the 3D picture, as a widget beside others.
#pragma once

#include <QCoreApplication>
#include <QSize>
#include <QWidget>
#include <memory>

#include "scene/camera/orbit_camera.h"

class QKeyEvent;
class QWindow;

namespace macula::viewer {

class WindowContainer {
    Q_DECLARE_TR_FUNCTIONS(WindowContainer)

  public:
    // Takes the window over, and fills `parent`, which outlives this.
    WindowContainer(QWindow& window, QWidget& parent);

    QWidget& widget() { return *widget_; }
    // The size at which the picture is first shown; a person may make it smaller.
    void setSizeHint(const QSize& devicePixels);
    // Moves the focus for Tab: no widget that knows the tab order sees the keys of a native window. Returns
    // whether the key was Tab.
    bool moveFocus(const QKeyEvent& event);
    void describeSides(const scene::EdgeLetters& letters);  // for people who cannot see the picture

  private:
    QWidget& parent_;
    std::unique_ptr<QWidget> widget_;
};

}  // namespace macula::viewer
