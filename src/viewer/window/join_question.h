// Whether images that agree in all but identifiers made anew for each of them are one series.
#pragma once

#include <QString>
#include <functional>

class QWidget;

namespace macula::viewer {

// Asks, and returns at once. `join` is called when the answer is yes; what is on screen stays until then.
void askToJoin(QWidget* parent, const QString& question, std::function<void()> join);

}  // namespace macula::viewer
