// What is asked before another patient's images come beside a study.
#pragma once

#include <QString>
#include <QStringList>
#include <functional>

class QWidget;

namespace macula::viewer {

// Waits for nobody; `open` is called when a person wants it all the same. `differs` are names of attributes,
// without values: "ID". Says no by itself when Enter or Esc is pressed.
void askAboutPatient(QWidget* parent, const QStringList& differs, std::function<void()> open,
                     std::function<void()> leave);

}  // namespace macula::viewer
