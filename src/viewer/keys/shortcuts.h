// Shortcuts that Qt does not find, and letters that are none.
#pragma once

class QAction;
class QKeyEvent;
class QMainWindow;
class QToolBar;

namespace macula::viewer {

// The enabled action of the window with these keys; null: none. Actions of `tools` count only while that is
// visible. Keys pressed in the native window do not pass through the widgets' shortcuts on every platform.
QAction* actionFor(const QKeyEvent& keys, const QMainWindow& window, const QToolBar& tools);

// Letters of tools are shortcuts of the window; in a list they look for an entry that begins with them.
// Returns whether a list that has the focus takes this letter.
bool isForList(const QKeyEvent& key);

}  // namespace macula::viewer
