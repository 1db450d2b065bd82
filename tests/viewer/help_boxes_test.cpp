// The table of keys: all of it can be read on a low screen.
#include "viewer/window/help_boxes.h"

#include <gtest/gtest.h>

#include <QDialog>
#include <QLabel>
#include <QPointer>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QTest>

#include "viewer/keys/keys.h"
#include "viewer/offscreen.h"

namespace macula::viewer {
namespace {

class HelpBoxes : public test::OffscreenTest {};

TEST_F(HelpBoxes, AllKeysAreReachedOnALowScreen) {
    QWidget window;
    showKeys(&window);
    const QPointer<QDialog> box = window.findChild<QDialog*>(QStringLiteral("keys"));
    ASSERT_FALSE(box.isNull());
    settle();
    EXPECT_LE(box->height(), box->screen()->availableGeometry().height());
    EXPECT_LE(box->width(), box->screen()->availableGeometry().width());
    auto* area = box->findChild<QScrollArea*>(QStringLiteral("keys-table"));
    ASSERT_NE(area, nullptr);
    const auto* table = qobject_cast<const QLabel*>(area->widget());
    ASSERT_NE(table, nullptr);
    for (const KeyRow& row : kKeys)
        EXPECT_TRUE(table->text().contains(QString::fromUtf8(row.does).toHtmlEscaped())) << row.does;
    // The screen of this platform is lower than the table.
    QScrollBar& bar = *area->verticalScrollBar();
    ASSERT_GT(bar.maximum(), 0);
    EXPECT_EQ(bar.maximum() + area->viewport()->height(), table->height()) << "to its last row";
    QTest::keyClick(area, Qt::Key_PageDown);
    EXPECT_GT(bar.value(), 0);
    QTest::keyClick(box, Qt::Key_Escape);
    settle();
    EXPECT_TRUE(box.isNull() || !box->isVisible());
}

}  // namespace
}  // namespace macula::viewer
