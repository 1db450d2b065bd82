// Panels and dialogs by the keyboard alone.
#include <QPushButton>
#include <QTabWidget>
#include <QVBoxLayout>

#include "scene/choice/catalogue.h"
#include "viewer/clip/clip_panel.h"
#include "viewer/editor/study_editor.h"
#include "viewer/keyboard_walk.h"
#include "viewer/offscreen.h"
#include "viewer/output/picture_dialog.h"
#include "viewer/panes/tool_box.h"
#include "viewer/settings/settings_dialog.h"
#include "viewer/slices/slice_view.h"
#include "viewer/status/status_widgets.h"
#include "viewer/theme/theme.h"
#include "viewer/transfer/transfer_function_editor.h"

namespace macula::viewer {
namespace {

class KeyboardTest : public test::OffscreenTest {
  protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        applyTheme(*application_, {});
        auto catalogue = scene::builtInCatalogue();
        ASSERT_TRUE(catalogue.ok());
        session_.emplace(*catalogue);
        session_->show(smallStudy(), {});
    }
    void TearDown() override {
        session_.reset();
        OffscreenTest::TearDown();
    }
    static void activate(QWidget& window) {
        window.show();
        window.activateWindow();
        ASSERT_TRUE(waitUntil([&] { return window.isActiveWindow(); }));
        settle();
    }
    // A panel stands in a window, beside something else that the focus can go to.
    void walk(QWidget* panel) {
        QWidget window;
        auto* column = new QVBoxLayout(&window);
        column->addWidget(panel);
        auto* beside = new QLineEdit;
        beside->setAccessibleName(QStringLiteral("beside"));
        beside->setToolTip(QStringLiteral("beside"));
        column->addWidget(beside);
        window.resize(500, 900);
        activate(window);
        test::expectWalkable(window);
    }

    std::optional<StudyEditor> session_;
};

TEST_F(KeyboardTest, TheClipPanel) {
    walk(new ClipPanel(*session_));
}

TEST_F(KeyboardTest, TheTransferFunction) {
    auto* editor = new TransferFunctionEditor(*session_);
    ASSERT_TRUE(waitUntil([&] { return !editor->isCounting(); }));
    editor->findChild<QPushButton*>(QStringLiteral("transfer-matter"))->click();
    walk(editor);
}

TEST_F(KeyboardTest, TheToolsOfSlices) {
    walk(new ToolBox(*session_));
}

TEST_F(KeyboardTest, ASlice) {
    walk(new SliceView(*session_, slices::Orientation::axial));
}

TEST_F(KeyboardTest, AMessage) {
    auto* bar = new MessageBar;
    bar->showNote(QStringLiteral("A note"));
    walk(bar);
}

TEST_F(KeyboardTest, TheSavingOfAPicture) {
    PictureDialog dialog(QSize(640, 480));
    activate(dialog);
    test::expectWalkable(dialog);
}

TEST_F(KeyboardTest, AllPagesOfSettings) {
    const KeyEntry entry{
        .id = QStringLiteral("F3"), .title = QStringLiteral("A"), .usual = QKeySequence(Qt::Key_F3)};
    SettingsDialog dialog({}, {entry}, true);
    activate(dialog);
    auto* pages = dialog.findChild<QTabWidget*>(QStringLiteral("settings-pages"));
    ASSERT_NE(pages, nullptr);
    EXPECT_GE(pages->count(), 4);
    for (int page = 0; page < pages->count(); ++page) {
        pages->setCurrentIndex(page);
        settle();
        test::expectWalkable(dialog);
    }
}

// The walk itself finds what is wrong.
TEST_F(KeyboardTest, WhatCannotBeReachedIsFound) {
    QWidget window;
    auto* column = new QVBoxLayout(&window);
    auto* reached = new QLineEdit;
    auto* silent = new QToolButton;
    silent->setFocusPolicy(Qt::NoFocus);
    column->addWidget(reached);
    column->addWidget(silent);
    activate(window);
    const std::vector<QWidget*> controls = test::controlsOf(window);
    EXPECT_EQ(std::set<QWidget*>(controls.begin(), controls.end()), (std::set<QWidget*>{reached, silent}));
}

}  // namespace
}  // namespace macula::viewer
