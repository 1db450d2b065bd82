// For controls in a panel that scrolls.
#pragma once

#include <QEvent>
#include <QObject>
#include <QWidget>

namespace macula::viewer {

// The wheel changes what has the focus, and scrolls past all else: a clip that changes by the way would show
// less of a patient than somebody thinks.
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
