// The window with a peripheral model: what is on screen while a hand moves, and after it.
#include <gtest/gtest.h>

#include <QComboBox>
#include <vector>

#include "pipeline/splat/train/trainer_options.h"
#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

using macula::test::devicesLost;
using macula::test::loseDeviceAt;
using macula::test::VulkanCall;

class ModelTest : public WindowTest {
  protected:
    std::vector<live::FrameShown> seen_;

    ModelTest() { usesModel_ = true; }
    void SetUp() override {
        WindowTest::SetUp();
        if (!window_) return;
        QObject::connect(&*window_, &MainWindow::frameShown, &*window_,
                         [this](const live::FrameShown& frame) { seen_.push_back(frame); });
    }
    bool isOnScreen(live::OnScreen picture) const {
        return !seen_.empty() && seen_.back().picture == picture;
    }
    bool waitFor(live::OnScreen picture) {
        return waitUntil([&] { return isOnScreen(picture); });
    }
    bool hasSeen(live::OnScreen picture) const {
        return std::any_of(seen_.begin(), seen_.end(),
                           [&](const live::FrameShown& frame) { return frame.picture == picture; });
    }
    void loseNow() {
        seen_.clear();
        loseDeviceAt(VulkanCall::submit, 1);
    }
    void press() { sendMouse(QEvent::MouseButtonPress, at_, Qt::LeftButton, Qt::LeftButton); }
    void move() {
        at_ += QPointF(6, 2);
        sendMouse(QEvent::MouseMove, at_, Qt::NoButton, Qt::LeftButton);
    }
    void release() { sendMouse(QEvent::MouseButtonRelease, at_, Qt::LeftButton, Qt::NoButton); }
    // Drags until `count` pictures followed.
    void drag(std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t before = seen_.size();
            move();
            ASSERT_TRUE(waitUntil([&] { return seen_.size() > before; }));
        }
    }
    void choosePreset(const char* name) {
        for (QComboBox* box : window_->findChildren<QComboBox*>()) {
            if (box->accessibleName() == QLatin1String("Preset"))
                Q_EMIT box->activated(box->findData(QString::fromLatin1(name), Qt::ToolTipRole));
        }
    }
    // "Preview sharpening, 130 steps", or "Preview sharp" when it has learnt all.
    bool isFit() const { return modelSays("Preview sharp"); }
    // "Preview not sharp yet, 40 steps": it learns.
    bool hasSteps() const { return modelSays(" steps"); }
    // So far that what is kept of it in case a device is lost, a little older, is fit to be shown too.
    bool learnWell() {
        if (!waitUntil([&] { return isFit(); })) return false;
        QElapsedTimer since;
        since.start();
        const auto isKept = [&] {
            return double(since.elapsed()) > 3.0 * splat::TrainerOptions{}.keepEveryMs;
        };
        return waitUntil([&] { return modelSays("Preview sharp, ") || isKept(); });
    }
    bool modelSays(const char* text) const { return window_->modelState().contains(QLatin1String(text)); }

  private:
    QPointF at_{100, 100};
};

TEST_F(ModelTest, InMotionEveryPictureIsOfTheModelWithAllPixelsAndAtRestItFadesIntoATracedOne) {
    window_->open(std::nullopt);
    ASSERT_TRUE(waitForConverged());
    EXPECT_EQ(window_->badge(), QLatin1String("Final"));
    ASSERT_TRUE(waitUntil([&] { return isFit(); }));
    // Nothing moves, nothing is drawn, however much the model learns.
    seen_.clear();
    QElapsedTimer idle;
    idle.start();
    waitUntil([&] { return idle.elapsed() > 500; });
    EXPECT_EQ(seen_.size(), 0u);

    press();
    drag(6);
    EXPECT_EQ(window_->badge(), QLatin1String("Preliminary"));
    for (const live::FrameShown& frame : seen_) {
        EXPECT_EQ(frame.picture, live::OnScreen::model);
        EXPECT_EQ(frame.stage, live::Stage::moving);
        EXPECT_EQ(QSize(frame.width, frame.height), window_->viewport().pictureSize());
        EXPECT_EQ(frame.scale, 1);
        EXPECT_GT(frame.model.splats, 1000u);
    }
    EXPECT_TRUE(window_->fidelity().startsWith(QLatin1String("Preview, ")))
        << window_->fidelity().toStdString();
    EXPECT_GT(coloursInTheMiddle(), 100);
    // As long as the hand holds on, the model stays.
    idle.restart();
    waitUntil([&] { return idle.elapsed() > 700; });
    EXPECT_EQ(seen_.back().stage, live::Stage::moving);
    EXPECT_TRUE(isOnScreen(live::OnScreen::model));
    seen_.clear();
    release();
    ASSERT_TRUE(waitForConverged());
    EXPECT_TRUE(hasSeen(live::OnScreen::fading));
    EXPECT_FALSE(hasSeen(live::OnScreen::preview));
    EXPECT_TRUE(window_->fidelity().startsWith(QLatin1String("Path traced, ")));
    // It goes on learning while nothing moves.
    EXPECT_TRUE(waitUntil([&] { return isFit(); }));
}

TEST_F(ModelTest, AnotherPresetIsNotShownByTheModelOfTheOneBeforeWhichComesBackWithIt) {
    window_->open(std::nullopt);
    ASSERT_TRUE(waitForConverged());
    seen_.clear();
    choosePreset("ct-bone");
    ASSERT_TRUE(waitUntil([&] { return !seen_.empty() && isOnScreen(live::OnScreen::traced); }));
    // Before there was a model of it that is fit to be shown it was estimated from the one before, and no
    // picture was small.
    EXPECT_EQ(seen_.front().picture, live::OnScreen::estimate);
    EXPECT_FALSE(hasSeen(live::OnScreen::preview));
    for (const live::FrameShown& frame : seen_) {
        EXPECT_TRUE(frame.picture != live::OnScreen::model || isFitToBeShown(frame.model))
            << frame.model.steps;
    }
    // The traced picture may have been final when it was first shown.
    ASSERT_TRUE(waitUntil([&] { return window_->badge() == QLatin1String("Final"); }));
    ASSERT_TRUE(waitUntil([&] { return isFit(); }));
    seen_.clear();
    choosePreset("cinematic-bone");
    ASSERT_TRUE(waitForConverged());
    seen_.clear();
    choosePreset("ct-bone");
    ASSERT_TRUE(waitUntil([&] { return !seen_.empty(); }));
    EXPECT_EQ(seen_.front().picture, live::OnScreen::model);

    // A projection has no model; the look after it has one again, of what is seen in that look.
    pressKey(Qt::Key_4, Qt::ControlModifier);
    ASSERT_TRUE(waitForConverged());
    EXPECT_TRUE(window_->fidelity().startsWith(QLatin1String("Maximum")));
    EXPECT_EQ(window_->modelState(), QString());
    seen_.clear();
    pressKey(Qt::Key_2, Qt::ControlModifier);
    ASSERT_TRUE(waitUntil([&] { return !seen_.empty() && seen_.back().model.steps > 0; }));
    EXPECT_EQ(seen_.back().look, trace::Look::clear);
    EXPECT_TRUE(waitUntil([&] { return window_->badge() == QLatin1String("Final"); }));
}

TEST_F(ModelTest, WithoutItAndInLooksThatHaveNoneThereAreSmallPictures) {
    window_->viewport().setUsesModel(false);
    window_->open(std::nullopt);
    ASSERT_TRUE(waitForConverged());
    press();
    drag(3);
    EXPECT_TRUE(isOnScreen(live::OnScreen::preview));
    release();
    ASSERT_TRUE(waitForConverged());
    EXPECT_FALSE(hasSeen(live::OnScreen::model));
    EXPECT_TRUE(window_->modelState().isEmpty());
    window_->viewport().setUsesModel(true);
    pressKey(Qt::Key_4, Qt::ControlModifier);
    ASSERT_TRUE(waitForConverged());
    seen_.clear();
    pressKey(Qt::Key_L);
    ASSERT_TRUE(waitForConverged());
    EXPECT_FALSE(hasSeen(live::OnScreen::model));
    EXPECT_TRUE(window_->modelState().isEmpty());
}

TEST_F(ModelTest, WithoutMemoryForItTheWindowSaysSoAndIsAsItIsWithoutAModel) {
    window_->viewport().setUsesModel(false);
    window_->open(std::nullopt);
    ASSERT_TRUE(waitForConverged());
    {
        // Pictures of this size have room, splats have none.
        const macula::test::NoMemory full(1'300'000);
        seen_.clear();
        window_->viewport().setUsesModel(true);
        ASSERT_TRUE(waitUntil([&] { return modelSays("No memory for a sharp preview"); }));
        EXPECT_GT(full.refused(), 0);
        press();
        drag(2);
        EXPECT_TRUE(isOnScreen(live::OnScreen::preview));
        release();
        ASSERT_TRUE(waitFor(live::OnScreen::traced)) << window_->message().toStdString();
        EXPECT_FALSE(hasSeen(live::OnScreen::model));
        EXPECT_TRUE(modelSays("No memory for a sharp preview"));
        EXPECT_TRUE(window_->message().isEmpty()) << window_->message().toStdString();
    }
    // Another clip or function leaves another room: it is tried again.
    choosePreset("cinematic-soft-tissue");
    ASSERT_TRUE(waitUntil([&] { return hasSteps(); }));
    EXPECT_FALSE(modelSays("No memory"));
}

// The third loss within a minute is not made good: two at a time.
TEST_F(ModelTest, ALostDeviceIsMadeGoodWhileItIsSearchedForAndWhileItIsShown) {
    window_->open(std::nullopt);
    ASSERT_TRUE(waitUntil([&] { return modelSays("Preparing the preview"); }));
    loseNow();
    ASSERT_TRUE(waitForConverged());
    EXPECT_EQ(devicesLost(), 1);
    ASSERT_TRUE(learnWell());

    press();
    drag(2);
    EXPECT_TRUE(isOnScreen(live::OnScreen::model));
    loseNow();
    drag(2);
    release();
    EXPECT_EQ(devicesLost(), 1);
    ASSERT_TRUE(waitForConverged());
    EXPECT_FALSE(hasSeen(live::OnScreen::preview)) << "what was learnt has outlived the device";
    EXPECT_TRUE(window_->message().isEmpty()) << window_->message().toStdString();
}

TEST_F(ModelTest, ALostDeviceIsMadeGoodWhileItFadesAndWhileItLearns) {
    window_->open(std::nullopt);
    ASSERT_TRUE(waitUntil([&] { return isFit(); }));
    press();
    drag(1);
    release();
    ASSERT_TRUE(waitFor(live::OnScreen::fading));
    loseNow();
    ASSERT_TRUE(waitForConverged());
    EXPECT_EQ(devicesLost(), 1);
    ASSERT_TRUE(learnWell());
    seen_.clear();
    loseDeviceAt(VulkanCall::submit, 3);
    ASSERT_TRUE(waitForConverged());
    EXPECT_EQ(devicesLost(), 1);
    EXPECT_FALSE(hasSeen(live::OnScreen::preview));
    EXPECT_GT(coloursInTheMiddle(), 100);
}

}  // namespace
}  // namespace macula::viewer
