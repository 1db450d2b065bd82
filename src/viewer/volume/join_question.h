// Asks whether images are one series if only their identifiers differ, newly made for each image.
#pragma once

#include <QString>
#include <functional>

class QWidget;

namespace macula::viewer {

// Asks, and returns at once. Calls `join` if the answer is yes; the study on screen stays until then.
void askToJoin(QWidget* parent, const QString& question, std::function<void()> join);

}  // namespace macula::viewer
