// Where the keyboard focus goes from a control that is greyed, and from one that is no widget to Qt.
#include "viewer/keys/focus_order.h"

#include <QComboBox>
#include <QLineEdit>
#include <QMainWindow>
#include <QPushButton>
#include <QVBoxLayout>

#include "viewer/offscreen.h"

namespace macula::viewer {
namespace {

class FocusOrderTest : public test::OffscreenTest {
  protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        window_.emplace();
        auto* centre = new QWidget;
        auto* column = new QVBoxLayout(centre);
        auto* group = new QWidget;
        auto* row = new QVBoxLayout(group);
        for (QPushButton*& button : buttons_) row->addWidget(button = new QPushButton);
        column->addWidget(picture_ = new QLineEdit);
        column->addWidget(group);
        column->addWidget(list_ = new QComboBox);
        list_->addItem(QStringLiteral("Axial"));
        window_->setCentralWidget(centre);
        new FocusOfGreyed(*window_, [this] { picture_->setFocus(); });
        window_->show();
        window_->activateWindow();
        ASSERT_TRUE(waitUntil([&] { return window_->isActiveWindow(); }));
    }
    void TearDown() override {
        window_.reset();
        OffscreenTest::TearDown();
    }
    static QWidget* focus() { return QApplication::focusWidget(); }

    std::optional<QMainWindow> window_;
    QLineEdit* picture_ = nullptr;
    std::array<QPushButton*, 3> buttons_{};
    QComboBox* list_ = nullptr;
};

TEST_F(FocusOrderTest, ItStaysInTheGroupAndElseGoesToThePicture) {
    buttons_[2]->setFocus();
    buttons_[2]->setEnabled(false);
    settle();
    EXPECT_EQ(focus(), buttons_[1]) << "and not the list, which would take letters";
    buttons_[0]->setEnabled(false);
    buttons_[1]->setEnabled(false);
    settle();
    EXPECT_EQ(focus(), picture_);
}

TEST_F(FocusOrderTest, WhatIsGreyedForAMomentKeepsIt) {
    buttons_[0]->setFocus();
    buttons_[0]->setEnabled(false);
    buttons_[0]->setEnabled(true);
    settle();
    EXPECT_EQ(focus(), buttons_[0]);
    buttons_[0]->setEnabled(false);
    settle();
    EXPECT_EQ(focus(), buttons_[1]) << "the next one first";
}

TEST_F(FocusOrderTest, APersonWhoHasGoneOnIsNotCalledBack) {
    buttons_[2]->setFocus();
    buttons_[2]->setEnabled(false);
    list_->setFocus();
    buttons_[1]->setFocus();
    settle();
    EXPECT_EQ(focus(), buttons_[1]);
}

TEST_F(FocusOrderTest, TabGoesRoundAndBackWithoutWhatCannotBeReached) {
    buttons_[1]->setEnabled(false);
    buttons_[2]->hide();
    EXPECT_EQ(nextInTabOrder(*picture_, true), buttons_[0]);
    EXPECT_EQ(nextInTabOrder(*buttons_[0], true), list_);
    EXPECT_EQ(nextInTabOrder(*list_, false), buttons_[0]);
    EXPECT_EQ(nextInTabOrder(*list_, true), picture_);
    EXPECT_EQ(nextInTabOrder(*picture_, false), list_);
}

}  // namespace
}  // namespace macula::viewer
