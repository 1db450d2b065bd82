// Undo and redo in menus: what they say, and when they can be used.
#include "viewer/editor/undo_actions.h"

#include <QKeySequence>
#include <QRegularExpression>

#include "viewer/editor/study_editor.h"
#include "viewer/editor/undo_steps.h"
#include "viewer/offscreen.h"

namespace macula::viewer {
namespace {

class UndoActionsTest : public test::OffscreenTest {
  protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        session_.emplace(scene::Catalogue{});
        actions_.emplace(*session_);
        session_->show(smallStudy(), {});
    }
    void TearDown() override {
        actions_.reset();
        session_.reset();
        OffscreenTest::TearDown();
    }
    void choose(const QString& what, scene::Layout layout) {
        session_->change(what, [&](scene::StudyState& next) { next.layout = layout; });
    }
    static QString plain(const QAction& action) {
        return QString(action.text()).remove(QRegularExpression(QStringLiteral("&(?!&)")));
    }

    std::optional<StudyEditor> session_;
    std::optional<UndoActions> actions_;
};

TEST_F(UndoActionsTest, CanBeUsedOnlyWhereThereIsSomething) {
    QAction& undo = actions_->undo();
    QAction& redo = actions_->redo();
    EXPECT_FALSE(undo.isEnabled());
    EXPECT_FALSE(redo.isEnabled());
    EXPECT_EQ(plain(undo), QStringLiteral("Undo"));
    choose(QStringLiteral("Layout"), scene::Layout::axial);
    EXPECT_TRUE(undo.isEnabled());
    EXPECT_FALSE(redo.isEnabled());
    EXPECT_EQ(plain(undo), QStringLiteral("Undo Layout"));
    undo.trigger();
    EXPECT_EQ(session_->state().layout, scene::Layout::fourPanes);
    EXPECT_FALSE(undo.isEnabled());
    EXPECT_EQ(plain(redo), QStringLiteral("Redo Layout"));
    redo.trigger();
    EXPECT_EQ(session_->state().layout, scene::Layout::axial);
    EXPECT_FALSE(redo.isEnabled());
    EXPECT_EQ(plain(redo), QStringLiteral("Redo"));
}

// Of something that hides the study: one step, which is taken back and made again.
class OneStep : public UndoSteps {
  public:
    QString undoText() const override { return isDone_ ? QStringLiteral("Line") : QString(); }
    QString redoText() const override { return isDone_ ? QString() : QStringLiteral("Line"); }
    void undo() override { isDone_ = false; }
    void redo() override { isDone_ = true; }
    bool isDone() const { return isDone_; }

  private:
    bool isDone_ = true;
};

TEST_F(UndoActionsTest, ActOnWhatHidesTheStudyWhileItDoes) {
    OneStep steps;
    actions_->actOn(&steps);
    EXPECT_TRUE(actions_->undo().isEnabled());
    EXPECT_TRUE(actions_->undo().text().contains(QStringLiteral("Line")));
    EXPECT_FALSE(actions_->redo().isEnabled());
    actions_->undo().trigger();
    EXPECT_FALSE(steps.isDone());
    actions_->update();
    EXPECT_FALSE(actions_->undo().isEnabled());
    actions_->redo().trigger();
    EXPECT_TRUE(steps.isDone());
    actions_->actOn(nullptr);
    EXPECT_FALSE(actions_->undo().isEnabled()) << "the study has no step";
}

TEST_F(UndoActionsTest, AnotherStudyHasNothingToUndo) {
    choose(QStringLiteral("Layout"), scene::Layout::axial);
    session_->show(smallStudy(), {});
    EXPECT_FALSE(actions_->undo().isEnabled());
    actions_->undo().trigger();
    EXPECT_EQ(session_->state(), scene::StudyState());
}

TEST_F(UndoActionsTest, HaveTheKeysOfTheDesktopAndTellAnyWord) {
    EXPECT_EQ(actions_->undo().shortcuts(), QKeySequence::keyBindings(QKeySequence::Undo));
    EXPECT_EQ(actions_->redo().shortcuts(), QKeySequence::keyBindings(QKeySequence::Redo));
    EXPECT_FALSE(actions_->undo().shortcuts().isEmpty());
    choose(QStringLiteral("A & %1"), scene::Layout::axial);
    EXPECT_TRUE(actions_->undo().text().endsWith(QStringLiteral(" A && %1")))
        << actions_->undo().text().toStdString();
}

}  // namespace
}  // namespace macula::viewer
