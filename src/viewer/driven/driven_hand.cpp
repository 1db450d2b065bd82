#include "viewer/driven/driven_hand.h"

#include <QAction>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <QWindow>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace macula::viewer {

namespace {

constexpr int kHandIntervalMs = 16;  // as often as a usual mouse and display
constexpr int kNotchEveryMs = 40;
constexpr int kNotch = 120;  // in eighths of a degree

QPointF onScreen(const QObject& target, QPointF at) {
    if (const auto* widget = qobject_cast<const QWidget*>(&target)) return widget->mapToGlobal(at);
    if (const auto* window = qobject_cast<const QWindow*>(&target)) return window->mapToGlobal(at);
    return at;
}

void send(QObject& target, QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::MouseButtons held,
          Qt::KeyboardModifiers modifiers) {
    QMouseEvent event(type, at, onScreen(target, at), button, held, modifiers);
    QCoreApplication::sendEvent(&target, &event);
}

void sendKey(QObject& target, int key, Qt::KeyboardModifiers modifiers, const QString& text = {}) {
    QKeyEvent pressed(QEvent::KeyPress, key, modifiers, text);
    QCoreApplication::sendEvent(&target, &pressed);
    QKeyEvent released(QEvent::KeyRelease, key, modifiers, text);
    QCoreApplication::sendEvent(&target, &released);
}

}  // namespace

DrivenHand::DrivenHand(MainWindow& window, QObject* parent) : QObject(parent), window_(window) {
    moves_.setTimerType(Qt::PreciseTimer);
    moves_.setInterval(kHandIntervalMs);
    connect(&moves_, &QTimer::timeout, this, &DrivenHand::move);
    turns_.setInterval(kNotchEveryMs);
    connect(&turns_, &QTimer::timeout, this, &DrivenHand::turn);
}

void DrivenHand::drag(Drag drag) {
    if (isBusy() || drag.target == nullptr) return;
    dragging_ = std::move(drag);
    target_ = dragging_.target;
    since_.start();
    send(*target_, QEvent::MouseButtonPress, dragging_.path(0.0), dragging_.button, dragging_.button,
         dragging_.modifiers);
    moves_.start();
}

void DrivenHand::drag(QObject& target, QPointF from, QPointF to, Qt::MouseButton button,
                      Qt::KeyboardModifiers modifiers) {
    Drag straight;
    straight.target = &target;
    straight.path = [from, to](double share) { return from + share * (to - from); };
    straight.button = button;
    straight.modifiers = modifiers;
    drag(std::move(straight));
}

void DrivenHand::dragAround(QObject& target, double radiusShare) {
    Drag circle;
    circle.target = &target;
    const QPointF middle = middleOf(target);
    const double radius = radiusShare * 2.0 * std::min(middle.x(), middle.y());
    circle.path = [middle, radius](double share) {
        const double angle = 2.0 * std::numbers::pi * share;
        return middle + radius * QPointF(std::cos(angle), std::sin(angle));
    };
    drag(std::move(circle));
}

void DrivenHand::move() {
    if (!target_) return endDrag();
    const double share = std::min(double(since_.elapsed()) / std::max(dragging_.lastsMs, 1), 1.0);
    const QPointF at = dragging_.path(share);
    send(*target_, QEvent::MouseMove, at, Qt::NoButton, dragging_.button, dragging_.modifiers);
    if (share < 1.0) return;
    if (target_)
        send(*target_, QEvent::MouseButtonRelease, at, dragging_.button, Qt::NoButton, dragging_.modifiers);
    endDrag();
}

void DrivenHand::endDrag() {
    moves_.stop();
    dragging_ = {};
    target_.clear();
}

void DrivenHand::turnWheel(QWidget& target, int notches) {
    if (isBusy() || notches == 0) return;
    target_ = &target;
    notches_ = notches;
    turns_.start();
}

void DrivenHand::turn() {
    if (!target_ || notches_ == 0) {
        notches_ = 0;
        turns_.stop();
        target_.clear();
        return;
    }
    const int direction = notches_ > 0 ? 1 : -1;
    notches_ -= direction;
    const QPointF at = middleOf(*target_);
    QWheelEvent event(at, onScreen(*target_, at), {}, QPoint(0, direction * kNotch), Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(target_, &event);
}

void DrivenHand::click(QWidget& target, QPointF at) {
    const QPointer<QWidget> still = &target;
    send(target, QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
    if (still) send(target, QEvent::MouseButtonRelease, at, Qt::LeftButton, Qt::NoButton, Qt::NoModifier);
}

void DrivenHand::press(int key, Qt::KeyboardModifiers modifiers) {
    sendKey(window_.viewport().window(), key, modifiers);
}

void DrivenHand::press(QWidget& target, int key, Qt::KeyboardModifiers modifiers) {
    const QPointer<QWidget> still = &target;
    QKeyEvent pressed(QEvent::KeyPress, key, modifiers);
    QCoreApplication::sendEvent(&target, &pressed);
    if (!still) return;
    QKeyEvent released(QEvent::KeyRelease, key, modifiers);
    QCoreApplication::sendEvent(&target, &released);
}

void DrivenHand::type(QWidget& target, const QString& text) {
    for (const QChar letter : text) sendKey(target, Qt::Key_unknown, Qt::NoModifier, QString(letter));
}

void DrivenHand::trigger(const char* action) {
    auto* found = find<QAction>(action);
    if (found == nullptr) return;
    if (!found->isEnabled()) {
        missing_ << found->objectName();
        return;
    }
    found->trigger();
}

QPointF DrivenHand::middleOf(const QObject& target) {
    if (const auto* widget = qobject_cast<const QWidget*>(&target))
        return {0.5 * widget->width(), 0.5 * widget->height()};
    if (const auto* window = qobject_cast<const QWindow*>(&target))
        return {0.5 * window->width(), 0.5 * window->height()};
    return {};
}

}  // namespace macula::viewer
