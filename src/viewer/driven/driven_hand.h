// A hand made of code: mouse, wheel and keys go through Qt's event system into widgets and the native window,
// as those of a person do.
#pragma once

#include "viewer/window/main_window.h"  // before Qt, see vulkan_window.h

#include <QElapsedTimer>
#include <QObject>
#include <QPointer>
#include <QStringList>
#include <QTimer>
#include <functional>

namespace macula::viewer {

class DrivenHand : public QObject {
    Q_OBJECT

  public:
    explicit DrivenHand(MainWindow& window, QObject* parent = nullptr);

    // A widget or a native window, with a place in it.
    struct Drag {
        QObject* target = nullptr;
        std::function<QPointF(double share)> path;  // share of the time, 0 to 1
        int lastsMs = 600;
        Qt::MouseButton button = Qt::LeftButton;
        Qt::KeyboardModifiers modifiers = Qt::NoModifier;
    };
    // Goes on by itself, as often as a usual mouse tells; one at a time. Ends where the target is gone.
    void drag(Drag drag);
    void drag(QObject& target, QPointF from, QPointF to, Qt::MouseButton button = Qt::LeftButton,
              Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    // Once around its middle, clockwise from the right; the radius is a share of its shorter side.
    void dragAround(QObject& target, double radiusShare);
    // One notch after the other; negative ones are towards the person.
    void turnWheel(QWidget& target, int notches);
    bool isBusy() const { return dragging_.target != nullptr || notches_ != 0; }

    void click(QWidget& target, QPointF at);
    // In the 3D picture, where all shortcuts of the window are taken too.
    void press(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    void press(QWidget& target, int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    void type(QWidget& target, const QString& text);
    // Of a menu or a bar, by the name of the object.
    void trigger(const char* action);
    // Of the window, by the name of the object. Null where there is none.
    template <class T>
    T* find(const char* name) {
        T* found = window_.findChild<T*>(QString::fromLatin1(name));
        if (found == nullptr) missing_ << QString::fromLatin1(name);
        return found;
    }
    // What was to be used, and was not there or could not be: what was measured then is less than it says.
    const QStringList& missing() const { return missing_; }

    static QPointF middleOf(const QObject& target);

  private:
    void move();
    void endDrag();
    void turn();

    MainWindow& window_;
    Drag dragging_;
    QPointer<QObject> target_;  // of the drag, or of the wheel
    QElapsedTimer since_;
    QTimer moves_;
    QTimer turns_;
    int notches_ = 0;
    QStringList missing_;
};

}  // namespace macula::viewer
