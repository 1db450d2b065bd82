// Guards controls in a scrolling panel against the wheel.
#pragma once

#include <QEvent>
#include <QObject>
#include <QWidget>

namespace macula::viewer {

// The wheel changes only the control that has the focus, and otherwise scrolls the panel: an accidental
// change of the clip could hide part of the patient unnoticed.
class WheelGuard : public QObject {
  public:
    using QObject::QObject;

    void watch(QWidget& control) {
        control.setFocusPolicy(Qt::StrongFocus);  // the wheel gives no focus
        control.installEventFilter(this);
    }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::Wheel || static_cast<QWidget*>(watched)->hasFocus()) return false;
        event->ignore();
        return true;
    }
};

}  // namespace macula::viewer
