#include "viewer/keys/focus_order.h"

#include <QAbstractButton>
#include <QApplication>
#include <QMainWindow>
#include <QPointer>
#include <QTimer>
#include <utility>

namespace macula::viewer {

namespace {

bool canBeReached(const QWidget& widget, const QWidget& window) {
    return (widget.focusPolicy() & Qt::TabFocus) == Qt::TabFocus && widget.focusProxy() == nullptr &&
           widget.isVisibleTo(&window) && widget.isEnabled() && widget.window() == &window;
}

// The nearest usable button of the same group; those after `greyed` come first.
QWidget* buttonBeside(const QWidget& greyed) {
    const QWidget* group = greyed.parentWidget();
    if (group == nullptr) return nullptr;
    QWidget* before = nullptr;
    bool isPast = false;
    for (auto* button : group->findChildren<QAbstractButton*>(Qt::FindDirectChildrenOnly)) {
        isPast = isPast || button == &greyed;
        if (button == &greyed || !canBeReached(*button, *greyed.window())) continue;
        if (isPast) return button;
        before = button;
    }
    return before;
}

}  // namespace

QWidget* nextInTabOrder(const QWidget& from, bool forward) {
    const QWidget& window = *from.window();
    const auto step = [forward](const QWidget& widget) {
        return forward ? widget.nextInFocusChain() : widget.previousInFocusChain();
    };
    for (QWidget* next = step(from); next != nullptr && next != &from; next = step(*next)) {
        if (canBeReached(*next, window)) return next;
    }
    return nullptr;
}

FocusOfGreyed::FocusOfGreyed(QMainWindow& window, std::function<void()> toPicture)
    : QObject(&window), window_(window), toPicture_(std::move(toPicture)) {
    connect(qApp, &QApplication::focusChanged, this, &FocusOfGreyed::onMoved);
}

// The same change may disable and enable other controls: only after it is complete is it known where the
// focus can stay.
void FocusOfGreyed::onMoved(QWidget* from, QWidget* to) {
    const bool isGreyed = from != nullptr && from->window() == &window_ && !from->isEnabled() &&
                          from->isVisible() && window_.isEnabled();
    if (!isGreyed) return;
    QTimer::singleShot(0, this, [this, greyed = QPointer(from), strayed = QPointer(to)] {
        if (!greyed || QApplication::focusWidget() != strayed) return;
        QWidget* stays = greyed->isEnabled() ? greyed.data() : buttonBeside(*greyed);
        stays != nullptr ? stays->setFocus(Qt::OtherFocusReason) : toPicture_();
    });
}

}  // namespace macula::viewer
