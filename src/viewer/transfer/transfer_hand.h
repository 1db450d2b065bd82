// The mouse on a plotted transfer function: drags of points, of all curves, and of the axis.
#pragma once

#include <QPointF>
#include <optional>

#include "viewer/transfer/transfer_edits.h"
#include "viewer/transfer/transfer_plot.h"

class QMouseEvent;
class QWheelEvent;
class QKeyEvent;

namespace macula::viewer {

// Needs a function in the plot.
class TransferHand {
  public:
    TransferHand(TransferPlot& plot, TransferEdits& edits) : plot_(plot), edits_(edits) {}  // outlive this

    bool isDragging() const { return drag_.has_value(); }
    void cancel() { drag_.reset(); }

    void press(QMouseEvent& event);  // not during a drag, like the next two
    void doubleClick(const QMouseEvent& event);
    void turnWheel(const QWheelEvent& event);
    void move(const QMouseEvent& event);
    void release(const QMouseEvent& event);

  private:
    enum class Held { point, whole, axis };
    struct Drag {
        Held held = Held::point;
        Qt::MouseButton button = Qt::LeftButton;
        QPointF from;
        TransferFunction base;  // the whole drag edits this, so that rounding does not add up
        scene::ValueAxis axis;
        PointId point = {};
        QPointF grabbedAt = {};  // offset of the handle from the pointer
    };

    void begin(Held held, const QMouseEvent& event);
    void beginPoint(const PointId& point, const QMouseEvent& event);
    void dragPoint(const QPointF& to);
    void dragWhole(const QPointF& to, Qt::KeyboardModifiers modifiers);
    void addAt(const QMouseEvent& event);

    TransferPlot& plot_;
    TransferEdits& edits_;
    std::optional<Drag> drag_;
};

// Steps of an arrow key that is held down are one drag.
class TransferKeys {
  public:
    TransferKeys(TransferPlot& plot, TransferEdits& edits) : plot_(plot), edits_(edits) {}  // outlive this

    // Whether the key edits points, even if the window has a shortcut for it.
    static bool isTaken(const QKeyEvent& event);
    bool press(const QKeyEvent& event);  // needs a function; returns whether it handled the key
    void release(const QKeyEvent& event);
    void end();  // ends the drag, if any
    void cancel() { isNudging_ = false; }

  private:
    bool nudge(int key, Qt::KeyboardModifiers modifiers);
    void nudgePoint(const PointId& point, double right, double up);
    void nudgeWhole(double right, double up, bool isScale);

    TransferPlot& plot_;
    TransferEdits& edits_;
    bool isNudging_ = false;
};

}  // namespace macula::viewer
