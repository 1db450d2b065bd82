// The context menu of a slice: fit, windows, own windows, and the label of a measurement.
#pragma once

#include <QMenu>
#include <functional>

#include "viewer/editor/study_editor.h"
#include "viewer/slices/own_window_list.h"

namespace macula::viewer {

struct SliceMenuOf {
    StudyEditor* session = nullptr;   // with an open study
    OwnWindowList* own = nullptr;     // null: no own windows
    DisplayWindow window = {};        // the current window
    std::function<void()> editLabel;  // edits the label of the measurement there; empty: no entry
    std::function<void()> fit = {};   // fits the pane that was clicked; empty: no entry
};

// Deletes itself when it is closed.
QMenu* makeSliceMenu(const SliceMenuOf& of, QWidget* parent);

// Asks for a name, and keeps the window under that name.
void askToKeepWindow(const SliceMenuOf& of, QWidget* parent);

}  // namespace macula::viewer
