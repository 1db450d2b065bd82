// Where the keyboard focus goes from a widget, where Qt itself does not know or goes astray.
#pragma once

#include <QObject>
#include <functional>

class QMainWindow;
class QWidget;

namespace macula::viewer {

// The widget that Tab goes to from `from`, or Shift + Tab; null where there is no other. For a native window,
// whose keys pass no widget.
QWidget* nextInTabOrder(const QWidget& from, bool forward);

// Keeps the focus near a control that was greyed while it had it. Qt gives it to whatever comes next in the
// window, such as a list, which then takes the letters that are meant for pictures.
class FocusOfGreyed : public QObject {
    Q_OBJECT

  public:
    // `toPicture` gives the focus to a picture, where no button beside the greyed one can be used. The window
    // must outlive it.
    FocusOfGreyed(QMainWindow& window, std::function<void()> toPicture);

  private:
    void onMoved(QWidget* from, QWidget* to);

    QMainWindow& window_;
    std::function<void()> toPicture_;
};

}  // namespace macula::viewer
