// Stores and restores the position and size of a window.
#pragma once

#include <QObject>
#include <QString>
#include <functional>

class QWidget;

namespace macula::viewer {

// Calls `keep` with the window's place, as text for placeWindow, whenever the window is asked to close.
class WindowPlace : public QObject {
    Q_OBJECT

  public:
    WindowPlace(QWidget& window, std::function<void(const QString& place)> keep);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    QWidget& window_;
    std::function<void(const QString&)> keep_;
};

// Places a window before it is shown: on an existing screen, and no larger than this screen. False for an
// invalid text.
bool placeWindow(QWidget& window, const QString& place);

}  // namespace macula::viewer
