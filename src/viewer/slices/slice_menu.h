// What a right click on a slice offers: all of it in the pane, windows, also of one's own, and the label of a
// measurement.
#pragma once

#include <QMenu>
#include <functional>

#include "viewer/session/viewer_session.h"
#include "viewer/slices/own_window_list.h"

namespace macula::viewer {

struct SliceMenuOf {
    ViewerSession* session = nullptr;  // of a study that is open
    OwnWindowList* own = nullptr;      // null: none are kept
    DisplayWindow window = {};         // that slices are seen through now
    std::function<void()> editLabel;   // of the measurement that is meant; empty: none is
    std::function<void()> fit = {};    // the pane that was clicked; empty: nothing fits it
};

// Goes when it is closed.
QMenu* makeSliceMenu(const SliceMenuOf& of, QWidget* parent);

// Asks for a name, and keeps the window under it.
void askToKeepWindow(const SliceMenuOf& of, QWidget* parent);

}  // namespace macula::viewer
