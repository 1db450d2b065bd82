// The native window that shows pictures and receives the mouse.
#pragma once

// Before Qt: its own Vulkan header hides the functions that ours in pipeline/gpu need.
#include <vulkan/vulkan_core.h>

#include <QCoreApplication>
#include <QPointF>
#include <QSize>
#include <QWidget>
#include <QWindow>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "scene/camera/orbit_camera.h"
#include "viewer/viewport/dropped.h"

class QKeyEvent;

namespace macula::viewer {

// Has a Vulkan surface from the first time it is on screen until its platform window is destroyed. Knows
// nothing of cameras: it turns mouse and wheel into drags, and passes keys on. Lives on the UI thread.
class VulkanWindow : public QWindow {
    Q_OBJECT

  public:
    // The look decides between window and zoom. `transfer` shifts and widens the transfer function; `tool` is
    // a drag that a Grab took.
    enum class Drag { orbit, pan, zoom, windowOrZoom, roll, transfer, tool };
    // Called when the left button goes down. Returns whether it takes the drag, instead of the camera.
    using Grab = std::function<bool(QPointF place, bool withShift)>;

    // `instance` must outlive the window.
    explicit VulkanWindow(QVulkanInstance* instance);
    ~VulkanWindow() override;

    QSize pixels() const;                              // device pixels
    VkSurfaceKHR surface() const { return surface_; }  // null before surfaceReady and from surfaceGoing on

    void setGrab(Grab grab) { grab_ = std::move(grab); }

    // Ends a drag whose release the window does not get. Does nothing without a drag.
    void endDrag();

  Q_SIGNALS:
    void surfaceReady();
    // Connect directly: when this returns, the surface is destroyed.
    void surfaceGoing();
    void surfaceFailed();
    void exposed();  // the window system wants it painted
    void hidden();
    void resized();

    // The pointer moved without a drag, or a drag began: -1 to 1, right and up are positive.
    void pointed(QPointF place);
    void doubleClicked(QPointF place);  // with the left button; place as in pointed()
    void clicked(QPointF place);        // with the left button, without motion; place as in pointed()
    void dragBegan();
    void dragged(macula::viewer::VulkanWindow::Drag drag, QPointF byPixels);  // logical pixels, y downwards
    void dragEnded();
    // For a grabbed drag, instead of dragBegan and dragged; dragEnded follows. A drag that ends without its
    // button's release emits no toolReleased.
    void toolMoved(QPointF place, bool withShift);
    void toolReleased(QPointF place, bool withShift);
    void wheelTurned(double notches, bool withShift);  // positive: away from the person
    void flyTurned(double notches);                    // the same with Alt
    void keyPressed(QKeyEvent* event);                 // if not accepted, it goes to the main window
    void dropped(const macula::viewer::Dropped& what);

  protected:
    bool event(QEvent* event) override;
    void exposeEvent(QExposeEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

  private:
    QPointF placeOf(QPointF position) const;
    std::optional<Drag> dragOf(const QMouseEvent& event) const;
    void createSurface();
    void loseSurface();

    Grab grab_;
    VkSurfaceKHR surface_ = VK_NULL_HANDLE;
    bool dragging_ = false;
    Drag drag_ = Drag::orbit;
    Qt::MouseButton dragButton_ = Qt::NoButton;
    QPointF last_;
    QPointF pressedAt_;
    bool hasMoved_ = false;       // farther than a click
    bool holdsTransfer_ = false;  // the transfer key is down
};

// The native window of the 3D picture, as a widget beside others.
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
