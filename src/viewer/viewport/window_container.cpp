#include "viewer/viewport/window_container.h"

#include <QKeyEvent>
#include <QSplitter>
#include <QTimer>
#include <QVBoxLayout>
#include <QWindow>
#include <string>

#include "viewer/keys/focus_order.h"

namespace macula::viewer {

namespace {

constexpr QSize kSmallestPicture{160, 120};

}  // namespace

WindowContainer::WindowContainer(QWindow& window, QWidget& parent)
    : parent_(parent), widget_(QWidget::createWindowContainer(&window, &parent)) {
    widget_->setFocusPolicy(Qt::StrongFocus);
    widget_->setObjectName(QStringLiteral("volume"));
    widget_->setAccessibleName(tr("The volume in 3D"));
    widget_->setToolTip(
        tr("Left drag or arrows walk around the patient, the wheel goes closer; sizes are in mm"));
    widget_->setMinimumSize(kSmallestPicture);
    QSizePolicy policy = widget_->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    widget_->setSizePolicy(policy);
    parent.setFocusProxy(widget_.get());
    auto* column = new QVBoxLayout(&parent);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(widget_.get());
}

void WindowContainer::setSizeHint(const QSize& devicePixels) {
    widget_->setMinimumSize(devicePixels / parent_.devicePixelRatioF());
    // Until the window is shown, Qt invalidates only the layout that holds the widget, and none above it.
    for (QWidget* above = &parent_; above != nullptr; above = above->parentWidget()) {
        if (above->layout() != nullptr) above->layout()->invalidate();
        if (auto* splitter = qobject_cast<QSplitter*>(above)) splitter->refresh();
        above->updateGeometry();
    }
    // Once the window has taken it over, the user may make it smaller again.
    QTimer::singleShot(0, widget_.get(),
                       [widget = widget_.get()] { widget->setMinimumSize(kSmallestPicture); });
}

bool WindowContainer::moveFocus(const QKeyEvent& event) {
    const bool isBack = event.key() == Qt::Key_Backtab ||
                        (event.key() == Qt::Key_Tab && event.modifiers().testFlag(Qt::ShiftModifier));
    if (!isBack && event.key() != Qt::Key_Tab) return false;
    if ((event.modifiers() & ~Qt::ShiftModifier) != Qt::NoModifier) return false;
    QWidget* next = nextInTabOrder(*widget_, !isBack);
    if (next == nullptr) return true;
    // The native window keeps getting the keys until its parent is the active window.
    parent_.window()->activateWindow();
    next->setFocus(isBack ? Qt::BacktabFocusReason : Qt::TabFocusReason);
    return true;
}

void WindowContainer::describeSides(const scene::EdgeLetters& letters) {
    const auto side = [](const std::string& text) { return QString::fromStdString(text); };
    widget_->setAccessibleDescription(
        letters.left.empty()
            ? QString()
            : tr("Sides of the patient at the left, right, top and bottom: %1, %2, %3, %4")
                  .arg(side(letters.left), side(letters.right), side(letters.top), side(letters.bottom)));
}

}  // namespace macula::viewer
