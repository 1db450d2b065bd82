// A scripted user: sends mouse, wheel and key events through Qt's event system to widgets and the native
// window.
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

    // A drag along a path in a widget or native window.
    struct Drag {
        QObject* target = nullptr;
        std::function<QPointF(double share)> path;  // share of the time, 0 to 1
        int lastsMs = 600;
        Qt::MouseButton button = Qt::LeftButton;
        Qt::KeyboardModifiers modifiers = Qt::NoModifier;
    };
    // Sends moves at the rate of a mouse. Does nothing while isBusy(); ends if the target is deleted.
    void drag(Drag drag);
    void drag(QObject& target, QPointF from, QPointF to, Qt::MouseButton button = Qt::LeftButton,
              Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    // Once around its middle, clockwise from the right; the radius is a share of its shorter side.
    void dragAround(QObject& target, double radiusShare);
    // Sends one notch after the other; negative turns towards the person.
    void turnWheel(QWidget& target, int notches);
    bool isBusy() const { return dragging_.target != nullptr || notches_ != 0; }

    void click(QWidget& target, QPointF at);
    // Sends the key to the 3D picture, where the window's shortcuts also work.
    void press(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    void press(QWidget& target, int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    void type(QWidget& target, const QString& text);
    // Triggers an action of a menu or tool bar by its object name.
    void trigger(const char* action);
    // Finds a child of the window by object name; a missing one gives null and an entry in missing().
    template <class T>
    T* find(const char* name) {
        T* found = window_.findChild<T*>(QString::fromLatin1(name));
        if (found == nullptr) missing_ << QString::fromLatin1(name);
        return found;
    }
    // Objects that were not found or not usable: the measurements then cover less than they claim.
    const QStringList& missing() const { return missing_; }

    static QPointF middleOf(const QObject& target);

  private:
    void move();
    void endDrag();
    void turn();

    MainWindow& window_;
    Drag dragging_;
    QPointer<QObject> target_;  // of the drag or the wheel
    QElapsedTimer since_;
    QTimer moves_;
    QTimer turns_;
    int notches_ = 0;
    QStringList missing_;
};

}  // namespace macula::viewer
