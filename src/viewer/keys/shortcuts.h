// Finds shortcuts that Qt misses, and letters that a list needs for itself.
#pragma once

class QAction;
class QKeyEvent;
class QMainWindow;
class QToolBar;

namespace macula::viewer {

// The enabled action of the window with these keys; null: none. Actions of `tools` count only while that is
// visible. Keys pressed in the native window do not pass through the widgets' shortcuts on every platform.
QAction* actionFor(const QKeyEvent& keys, const QMainWindow& window, const QToolBar& tools);

// The letters of the slice tools are shortcuts of the window, but a list jumps to the entry that begins with
// a letter. Returns whether a list has the focus and should get this key.
bool isForList(const QKeyEvent& key);

}  // namespace macula::viewer
