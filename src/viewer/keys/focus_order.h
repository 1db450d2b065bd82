// Moves the keyboard focus where Qt does not, or would choose the wrong widget.
#pragma once

#include <QObject>
#include <functional>

class QMainWindow;
class QWidget;

namespace macula::viewer {

// The next widget for Tab, or for Shift + Tab; null if there is no other. For native windows, whose keys do
// not go through widgets.
QWidget* nextInTabOrder(const QWidget& from, bool forward);

// When a control is disabled while it has the focus, moves the focus to a neighbour. Qt would pass it to the
// next widget, such as a list, which then takes the letters meant for pictures.
class FocusOfGreyed : public QObject {
    Q_OBJECT

  public:
    // `toPicture` focuses a picture when no button beside the disabled one is usable. The window must outlive
    // it.
    FocusOfGreyed(QMainWindow& window, std::function<void()> toPicture);

  private:
    void onMoved(QWidget* from, QWidget* to);

    QMainWindow& window_;
    std::function<void()> toPicture_;
};

}  // namespace macula::viewer
