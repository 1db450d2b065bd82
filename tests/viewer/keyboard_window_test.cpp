// The window by the keyboard alone: its bars, panes and panels.
#include "viewer/window_fixture.h"  // before Qt, see vulkan_window.h

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>

#include "viewer/keyboard_walk.h"
#include "viewer/keys/keys.h"
#include "viewer/panes/pane_grid.h"
#include "viewer/settings/key_book.h"
#include "viewer/theme/theme.h"

namespace macula::viewer {
namespace {

class KeyboardWindowTest : public WindowTest {
  protected:
    void SetUp() override {
        layout_ = scene::Layout::fourPanes;
        WindowTest::SetUp();
    }
    void TearDown() override {
        KeyBook::ofProgram().setOwn({});
        WindowTest::TearDown();
    }
};

// Who hears the window, and who rests the pointer on it, is told what each control is.
TEST_F(KeyboardWindowTest, AllControlsAreExplained) {
    window_->resize(1200, 900);
    for (QDockWidget* panel : window_->findChildren<QDockWidget*>()) panel->show();
    window_->showStudy(smallStudy(Unit::hounsfield));
    QCoreApplication::processEvents();
    const std::vector<QWidget*> controls = test::controlsOf(*window_);
    EXPECT_GT(controls.size(), 20u);
    for (QWidget* control : controls) {
        test::expectIsExplained(*control);
        EXPECT_TRUE(test::isReachedByTab(*control)) << test::describe(*control);
    }
}

// The picture is a native window, whose keys pass no widget: Tab goes on from it all the same.
TEST_F(KeyboardWindowTest, TabGoesThroughAllPanesAndBack) {
    window_->resize(1200, 900);
    window_->showStudy(smallStudy(Unit::hounsfield));
    for (const bool forward : {true, false}) {
        const auto key = forward ? Qt::Key_Tab : Qt::Key_Backtab;
        window_->panes().focusPane(Pane::volume);
        QWidget* const picture = QApplication::focusWidget();
        std::set<Pane> seen;
        pressKey(key, forward ? Qt::NoModifier : Qt::ShiftModifier);
        ASSERT_TRUE(waitUntil([&] {
            QWidget* const focus = QApplication::focusWidget();
            return focus != nullptr && focus != picture;
        })) << "Tab is trapped";
        // Whether the picture has the keys again is for the window manager, which tests have none of.
        for (int pressed = 0; pressed < test::kMostTabs && seen.size() + 1 < kPanes.size(); ++pressed) {
            QWidget* before = QApplication::focusWidget();
            ASSERT_NE(before, nullptr);
            QTest::keyClick(before, key);
            ASSERT_TRUE(waitUntil([&] { return QApplication::focusWidget() != before; }))
                << test::describe(*before);
            const auto active = window_->panes().activePane();
            if (active && *active != Pane::volume) seen.insert(*active);
        }
        EXPECT_EQ(seen.size() + 1, kPanes.size());
    }
}

TEST_F(KeyboardWindowTest, EveryActionIsInAMenuWithWordsOrAKey) {
    const QList<KeyEntry> entries = KeyBook::entriesOf(*window_);
    EXPECT_GT(entries.size(), 30);
    std::set<QString> ids;
    for (const KeyEntry& entry : entries) {
        EXPECT_TRUE(ids.insert(entry.id).second) << entry.id.toStdString() << " is there twice";
        EXPECT_FALSE(entry.title.endsWith(QLatin1String(": "))) << entry.id.toStdString();
        EXPECT_EQ(troubleWith(entry.usual, entry, entries, {}), std::nullopt) << entry.title.toStdString();
    }
}

TEST_F(KeyboardWindowTest, AKeyThatWasChosenWorksAndTheUsualOneDoesNot) {
    auto* picture = window_->findChild<QAction*>(QStringLiteral("save-picture"));
    ASSERT_NE(picture, nullptr);
    EXPECT_EQ(picture->shortcut(), QKeySequence(Qt::CTRL | Qt::Key_E));
    Settings settings = window_->settings();
    settings.keys = {{QStringLiteral("Ctrl+E"), QStringLiteral("Ctrl+Alt+P")},
                     {QStringLiteral("F"), QStringLiteral("H")}};
    window_->takeSettings(settings);
    EXPECT_EQ(picture->shortcut(), QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_P));
    EXPECT_EQ(actionOf(QKeyEvent(QEvent::KeyPress, Qt::Key_H, Qt::NoModifier)), KeyAction::fit);
    EXPECT_EQ(actionOf(QKeyEvent(QEvent::KeyPress, Qt::Key_F, Qt::NoModifier)), std::nullopt);
    settings.keys.clear();
    window_->takeSettings(settings);
    EXPECT_EQ(picture->shortcut(), QKeySequence(Qt::CTRL | Qt::Key_E));
}

}  // namespace
}  // namespace macula::viewer
