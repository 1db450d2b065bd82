// Whether the program is to end while something is still being written.
#pragma once

#include <QStringList>
#include <functional>

class QWidget;

namespace macula::viewer {

// Asks, and returns at once. `unfinished`: sentences. `wait` is called when the program is to end after that,
// `quit` when it is to end now; neither when it is to go on.
void askToQuit(QWidget* parent, const QStringList& unfinished, std::function<void()> wait,
               std::function<void()> quit);

}  // namespace macula::viewer
