// The context menu of a pane of slices.
#pragma once

#include <functional>
#include <optional>

#include "base/volume.h"
#include "viewer/editor/study_editor.h"
#include "viewer/slices/slice_windowing.h"

class QMenu;
class QWidget;

namespace macula::viewer {

struct SliceMenuOf {
    StudyEditor* session = nullptr;     // with an open study
    OwnWindowList* own = nullptr;       // null: no own windows
    DisplayWindow window = {};          // the current window
    std::function<void()> editLabel;    // edits the label of the measurement there; empty: no entry
    std::optional<bool> isNode = {};    // of a lesion with both axes there; nothing: no entry
    std::function<void(bool)> setNode;  // calls it a lymph node, or not
    std::function<void()> fit;          // fits the pane that was clicked
    std::function<void()> copyPicture;  // to the clipboard
    std::function<void()> savePicture;  // to a file
    std::function<void()> savePlanes;   // planes like the one that is shown, as DICOM
};

// Deletes itself when it is closed.
QMenu* makeSliceMenu(const SliceMenuOf& of, QWidget* parent);

}  // namespace macula::viewer
