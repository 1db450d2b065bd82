// What several features tell in one bar: notes on the study, messages, and work.
#include "viewer/status/study_notes.h"

#include <gtest/gtest.h>

#include <QVBoxLayout>
#include <optional>
#include <vector>

#include "viewer/offscreen.h"
#include "viewer/status/notifications.h"
#include "viewer/status/status_widgets.h"

namespace macula::viewer {
namespace {

class StudyNotesTest : public test::OffscreenTest {
  protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        window_.emplace();
        notes_.emplace();
        notifications_.emplace();
        auto* column = new QVBoxLayout(&*window_);
        column->addWidget(&notes_->bar());
        column->addWidget(&notifications_->bar());
        window_->show();
    }
    void TearDown() override {
        notifications_.reset();
        notes_.reset();
        window_.reset();
        OffscreenTest::TearDown();
    }

    std::optional<QWidget> window_;
    std::optional<StudyNotes> notes_;
    std::optional<Notifications> notifications_;
};

TEST_F(StudyNotesTest, StandInOneOrderWhoeverComesFirst) {
    notes_->set(NoteOn::device, QStringLiteral("Last."));
    notes_->set(NoteOn::study, QStringList{QStringLiteral("Second."), QStringLiteral("Third.")});
    notes_->setSource(NoteOn::visibility, [] { return QStringList{QStringLiteral("First.")}; });
    EXPECT_EQ(notes_->text(), QString()) << "nothing is shown before it is asked for";
    notes_->show();
    EXPECT_EQ(notes_->text(), QStringLiteral("First. Second. Third. Last."));
}

TEST_F(StudyNotesTest, ThatWereDismissedComeBackOnlyWithNews) {
    const QString note = QStringLiteral("The preset is not made for this.");
    notes_->showIfOther(NoteOn::preset, note);
    EXPECT_EQ(notes_->text(), note);
    notes_->bar().hide();
    notes_->showIfOther(NoteOn::preset, note);
    EXPECT_EQ(notes_->text(), QString());
    notes_->showIfOther(NoteOn::picture, QStringLiteral("Less is shown."));
    EXPECT_EQ(notes_->text(), note + QStringLiteral(" Less is shown."));
    notes_->set(NoteOn::picture, QString());
    notes_->showIfOther(NoteOn::preset, QString());
    EXPECT_FALSE(notes_->bar().isVisible());
}

TEST_F(StudyNotesTest, FailuresAreShownAndSignalled) {
    std::vector<std::string> failures;
    QObject::connect(&*notifications_, &Notifications::failed, &*window_,
                     [&](const Error& error) { failures.push_back(error.message.english()); });
    notifications_->showError({ErrorCode::usage, Text("Only shown.")});
    EXPECT_TRUE(failures.empty());
    notifications_->failUnlessCancelled({ErrorCode::cancelled, Text("By a person.")});
    EXPECT_TRUE(failures.empty());
    EXPECT_EQ(notifications_->text(), QStringLiteral("Only shown."));
    notifications_->fail({ErrorCode::usage, Text("Failed.")},
                         {ErrorCode::usage, Text("Failed, in other words.")});
    EXPECT_EQ(failures, std::vector<std::string>{"Failed."});
    EXPECT_EQ(notifications_->text(), QStringLiteral("Failed, in other words."));
}

TEST_F(StudyNotesTest, WhatNeedsAStudySaysSo) {
    EXPECT_TRUE(notifications_->refuseUnless(true, QStringLiteral("There is no picture.")));
    EXPECT_EQ(notifications_->text(), QString());
    EXPECT_FALSE(notifications_->refuseUnless(false, QStringLiteral("There is no picture.")));
    EXPECT_EQ(notifications_->text(), QStringLiteral("There is no picture. Open a study first."));
}

}  // namespace
}  // namespace macula::viewer
