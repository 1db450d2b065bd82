// What stays on screen when the window system or the device fails at the wrong moment; see gpu/lose_device.h.
#include <gtest/gtest.h>

#include <QAction>

#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

using macula::test::answerFalsely;
using macula::test::falseAnswersLeft;
using macula::test::VulkanCall;

class ScreenTest : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (!window_) return;
        QObject::connect(&*window_, &MainWindow::failed, &*window_, [this](const Error& e) { error_ = e; });
        window_->showStudy(smallStudy(Unit::hounsfield));
        ASSERT_TRUE(waitForConverged());
        ASSERT_GT(coloursInTheMiddle(), 20);
    }
    void TearDown() override {
        answerFalsely({.times = 0});
        WindowTest::TearDown();
    }

    std::optional<Error> error_;
};

TEST_F(ScreenTest, APictureThatCouldNotBeTakenOffInTimeIsTakenOffAfterAnError) {
    answerFalsely({.call = VulkanCall::acquire, .result = VK_TIMEOUT, .times = 10});
    window_->showStudy(studyThatCannotBeShown());
    ASSERT_TRUE(waitUntil([&] { return error_.has_value(); }));
    EXPECT_TRUE(waitUntil([&] { return coloursInTheMiddle() == 1; }));
}

TEST_F(ScreenTest, APictureThatCanNeverBeTakenOffIsHidden) {
    answerFalsely({.call = VulkanCall::acquire, .result = VK_TIMEOUT, .times = 1'000'000});
    window_->showStudy(studyThatCannotBeShown());
    ASSERT_TRUE(waitUntil([&] { return error_.has_value(); }));
    EXPECT_TRUE(waitUntil([&] { return coloursInTheMiddle() == 1; }));
    // Who opens something else sees that.
    answerFalsely({.times = 0});
    window_->showStudy(smallStudy(Unit::hounsfield));
    ASSERT_TRUE(waitForConverged());
    EXPECT_GT(coloursInTheMiddle(), 20);
}

TEST_F(ScreenTest, ADeviceThatIsGivenUpLeavesNoPicture) {
    macula::test::loseDeviceAt(VulkanCall::submit, 5, 1000);
    pressKey(Qt::Key_L);
    ASSERT_TRUE(waitUntil([&] { return error_.has_value(); }));
    EXPECT_EQ(error_->code, ErrorCode::deviceLost);
    EXPECT_TRUE(waitUntil([&] { return coloursInTheMiddle() == 1; }));
}

TEST_F(ScreenTest, TheLastPictureComesHoweverLateTheWindowSystemIs) {
    // More than there are pictures until then.
    answerFalsely({.call = VulkanCall::acquire, .result = VK_TIMEOUT, .times = 60});
    pressKey(Qt::Key_L);
    EXPECT_TRUE(waitForConverged());
    EXPECT_EQ(falseAnswersLeft(), 0);
    EXPECT_TRUE(window_->fidelity().contains(QStringLiteral("complete")));
}

TEST_F(ScreenTest, ImagesThatWereNotPresentedAreNotLost) {
    // More often than the window has images. Not for lack of memory: the model would be given up for that.
    for (int i = 0; i < 6; ++i) {
        error_.reset();
        answerFalsely(
            {.call = VulkanCall::submit, .result = VK_ERROR_UNKNOWN, .times = 1, .onlyAfterAcquire = true});
        pressKey(i % 2 == 0 ? Qt::Key_L : Qt::Key_A);
        ASSERT_TRUE(waitUntil([&] { return error_.has_value(); })) << i;
        EXPECT_EQ(falseAnswersLeft(), 0);
        EXPECT_TRUE(waitUntil([&] { return coloursInTheMiddle() == 1; })) << i;
    }
    pressKey(Qt::Key_R);
    ASSERT_TRUE(waitForConverged());
    EXPECT_GT(coloursInTheMiddle(), 20);
}

TEST_F(ScreenTest, AWindowWhoseSizeCouldNotBeTakenOverShowsThePictureAllTheSame) {
    answerFalsely({.call = VulkanCall::swapchain, .result = VK_ERROR_UNKNOWN, .times = 2});
    window_->resize(window_->size() + QSize(64, 32));
    ASSERT_TRUE(waitUntil([&] { return error_.has_value(); }));
    EXPECT_TRUE(waitUntil([&] { return coloursInTheMiddle() == 1; }));
    answerFalsely({.times = 0});
    pressKey(Qt::Key_L);
    ASSERT_TRUE(waitForConverged());
    EXPECT_GT(coloursInTheMiddle(), 20);
}

}  // namespace
}  // namespace macula::viewer
