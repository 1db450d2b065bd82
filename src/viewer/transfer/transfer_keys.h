// The keys on a plotted transfer function.
#pragma once

#include "viewer/transfer/transfer_edits.h"
#include "viewer/transfer/transfer_plot.h"

class QKeyEvent;

namespace macula::viewer {

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
