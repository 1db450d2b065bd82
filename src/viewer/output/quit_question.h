// The question whether to quit while files are being written.
#pragma once

#include <QStringList>
#include <functional>

class QWidget;

namespace macula::viewer {

// Asks, and returns at once. `unfinished`: sentences. Calls `wait` to quit after the work, `quit` to quit
// now, and neither after Cancel.
void askToQuit(QWidget* parent, const QStringList& unfinished, std::function<void()> wait,
               std::function<void()> quit);

}  // namespace macula::viewer
