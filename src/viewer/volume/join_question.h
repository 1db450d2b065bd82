// The question whether images that differ only in identifiers made anew for each are one series.
#pragma once

#include <QString>
#include <functional>

class QWidget;

namespace macula::viewer {

// Asks, and returns at once. Calls `join` if the answer is yes; the study on screen stays until then.
void askToJoin(QWidget* parent, const QString& question, std::function<void()> join);

}  // namespace macula::viewer
