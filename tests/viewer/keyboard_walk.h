// Goes through a window by the Tab key alone, as somebody without a mouse does.
#pragma once

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QImage>
#include <QKeySequenceEdit>
#include <QLineEdit>
#include <QPixmap>
#include <QScrollBar>
#include <QSpinBox>
#include <QTest>
#include <QWidget>
#include <set>
#include <string>
#include <vector>

namespace macula::viewer::test {

inline constexpr int kMostTabs = 400;  // a transfer function has a stop at each of its points

inline std::string describe(const QWidget& widget) {
    return widget.objectName().toStdString() + " (" + widget.metaObject()->className() + ")";
}

// What belongs to a control, and not to the person: scroll bars, fields in boxes, buttons in fields, and what
// Qt has in title bars.
inline bool isPartOfAnother(const QWidget& widget) {
    if (widget.objectName().startsWith(QLatin1String("qt_"))) return true;
    if (qobject_cast<const QScrollBar*>(&widget) != nullptr) return true;
    for (const QWidget* above = widget.parentWidget(); above != nullptr; above = above->parentWidget()) {
        if (qobject_cast<const QAbstractSpinBox*>(above) != nullptr ||
            qobject_cast<const QComboBox*>(above) != nullptr ||
            qobject_cast<const QLineEdit*>(above) != nullptr ||
            qobject_cast<const QKeySequenceEdit*>(above) != nullptr ||
            qobject_cast<const QAbstractItemView*>(above) != nullptr)
            return true;
    }
    return false;
}

// What hands the focus on to a part of it, as pages do to their tabs, is reached there.
inline bool isReachedByTab(const QWidget& widget) {
    return (widget.focusPolicy() & Qt::TabFocus) != 0 && widget.focusProxy() == nullptr;
}

inline bool isControl(const QWidget& widget) {
    if (!widget.isVisible() || !widget.isEnabled() || isPartOfAnother(widget)) return false;
    return isReachedByTab(widget) || qobject_cast<const QAbstractButton*>(&widget) != nullptr ||
           qobject_cast<const QComboBox*>(&widget) != nullptr ||
           qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr ||
           qobject_cast<const QAbstractSlider*>(&widget) != nullptr ||
           qobject_cast<const QLineEdit*>(&widget) != nullptr ||
           qobject_cast<const QAbstractItemView*>(&widget) != nullptr;
}

inline std::vector<QWidget*> controlsOf(QWidget& root) {
    std::vector<QWidget*> controls;
    for (QWidget* widget : root.findChildren<QWidget*>()) {
        if (widget->window() == root.window() && isControl(*widget)) controls.push_back(widget);
    }
    return controls;
}

inline QString unitOf(const QWidget& widget) {
    if (const auto* box = qobject_cast<const QDoubleSpinBox*>(&widget)) return box->suffix().trimmed();
    if (const auto* box = qobject_cast<const QSpinBox*>(&widget)) return box->suffix().trimmed();
    return {};
}

// A name for who hears the window, and a tool tip that says what it is, with the unit of its number.
inline void expectIsExplained(QWidget& control) {
    const QAccessibleInterface* heard = QAccessible::queryAccessibleInterface(&control);
    ASSERT_NE(heard, nullptr) << describe(control);
    EXPECT_FALSE(heard->text(QAccessible::Name).isEmpty()) << describe(control) << " has no accessible name";
    EXPECT_FALSE(control.toolTip().isEmpty()) << describe(control) << " has no tool tip";
    QString unit = unitOf(control);
    if (unit == QLatin1String("px")) unit = QStringLiteral("pixels");
    EXPECT_TRUE(unit.isEmpty() || control.toolTip().contains(unit))
        << describe(control) << " does not say " << unit.toStdString();
}

inline QImage pictureOf(QWidget& widget) {
    return widget.window()->grab(QRect(widget.mapTo(widget.window(), QPoint(0, 0)), widget.size())).toImage();
}

// Each control of `root`, a window that is active, is reached, explained, and looks otherwise with the focus.
inline void expectWalkable(QWidget& root) {
    std::set<QWidget*> missed;
    for (QWidget* control : controlsOf(root)) {
        expectIsExplained(*control);
        missed.insert(control);
    }
    ASSERT_FALSE(missed.empty());
    const auto count = missed.size();
    for (int pressed = 0; pressed < kMostTabs && !missed.empty(); ++pressed) {
        QWidget* before = QApplication::focusWidget();
        while (before != nullptr && isPartOfAnother(*before)) before = before->parentWidget();
        const QImage withFocus = before != nullptr ? pictureOf(*before) : QImage();
        QTest::keyClick(before != nullptr ? before : &root, Qt::Key_Tab);
        const QWidget* now = QApplication::focusWidget();
        ASSERT_NE(now, nullptr) << "the focus is gone after " << (before ? describe(*before) : "nothing");
        // What had the focus before a key was pressed does not show it: it is seen when Tab comes back to it.
        if (pressed > 0 && before != nullptr && before != now && missed.erase(before) > 0) {
            EXPECT_NE(withFocus, pictureOf(*before)) << describe(*before) << " does not show the focus";
        }
    }
    for (const QWidget* control : missed)
        ADD_FAILURE() << "Tab does not reach " << describe(*control) << ", one of " << count;
}

}  // namespace macula::viewer::test
