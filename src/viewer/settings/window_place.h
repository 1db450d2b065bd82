// Where a window stood on the desktop, and how large it was.
#pragma once

#include <QObject>
#include <QString>
#include <functional>

class QWidget;

namespace macula::viewer {

// Tells `keep` where the window is whenever it is asked to close, as text for placeWindow.
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

// Puts a window that is not shown yet there: on a screen that exists, and no larger than it. False where the
// text is none of a place.
bool placeWindow(QWidget& window, const QString& place);

}  // namespace macula::viewer
