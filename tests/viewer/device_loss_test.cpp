// The window while its graphics device is lost; see gpu/lose_device.h.
#include <gtest/gtest.h>

#include <QAction>
#include <atomic>
#include <cstdlib>
#include <new>

#include "viewer/window_fixture.h"

namespace {
std::atomic<bool> memoryEndsAtALoss = false;  // the next allocation of the thread that was told of one fails
}

void* operator new(std::size_t bytes) {
    if (memoryEndsAtALoss && macula::test::lossesOnThisThread() > 0 && memoryEndsAtALoss.exchange(false)) {
        throw std::bad_alloc();
    }
    if (void* memory = std::malloc(bytes == 0 ? 1 : bytes)) return memory;
    throw std::bad_alloc();
}
// A sanitizer has its own of what is not replaced, which would not go with the deletes below.
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept try {
    return operator new(bytes);
} catch (const std::bad_alloc&) {
    return nullptr;
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace macula::viewer {
namespace {

using macula::test::devicesLost;
using macula::test::loseDeviceAt;
using macula::test::VulkanCall;

TEST_F(WindowTest, ALostDeviceIsReplacedAndThePictureComesBack) {
    window_->open(std::nullopt);
    ASSERT_TRUE(waitForConverged());
    const auto look = [&](int key) {
        pressKey(key);
        EXPECT_TRUE(waitForConverged());
    };
    loseDeviceAt(VulkanCall::wait, 3);
    look(Qt::Key_L);
    EXPECT_EQ(devicesLost(), 1);
    EXPECT_TRUE(window_->notes().contains(QStringLiteral("stopped responding and was started again")));
    EXPECT_FALSE(window_->description().isEmpty());
    EXPECT_GT(coloursInTheMiddle(), 100);
    // A look without noise: its picture is the same every time, denoised by nobody however busy the machine.
    window_->findChild<QAction*>(QStringLiteral("look-dvr"))->trigger();
    ASSERT_TRUE(waitForConverged());
    loseDeviceAt(VulkanCall::present, 2);
    look(Qt::Key_A);
    EXPECT_EQ(devicesLost(), 1);
    EXPECT_EQ(window_->viewport().letters().left, "R");
    EXPECT_GT(coloursInTheMiddle(), 100);
    const QImage afterALoss = middle();
    // The same without one, in the window that the note has made smaller.
    look(Qt::Key_L);
    EXPECT_FALSE(middle() == afterALoss);
    look(Qt::Key_A);
    EXPECT_TRUE(middle() == afterALoss);
}

TEST_F(WindowTest, ADeviceThatIsLostAgainAndAgainIsGivenUpAndSaidToBe) {
    window_->open(std::nullopt);
    ASSERT_TRUE(waitForConverged());
    std::optional<Error> error;
    QObject::connect(&*window_, &MainWindow::failed, &*window_, [&](const Error& e) { error = e; });
    loseDeviceAt(VulkanCall::submit, 5, 1000);
    pressKey(Qt::Key_L);
    ASSERT_TRUE(waitUntil([&] { return error.has_value(); }));
    EXPECT_EQ(error->code, ErrorCode::deviceLost);
    EXPECT_EQ(devicesLost(), 3);
    // Nor does a window that takes another size, as this one may have done around the sentence.
    error.reset();
    const int width = window_->viewport().width();
    window_->resize(window_->width() + 40, window_->height() + 30);
    ASSERT_TRUE(waitUntil([&] { return window_->viewport().width() != width; }));
    EXPECT_FALSE(waitUntil([&] { return error.has_value(); }, 1));
    EXPECT_EQ(devicesLost(), 3);
    EXPECT_TRUE(window_->message().contains(QStringLiteral("driver")));
    EXPECT_FALSE(window_->notes().contains(QStringLiteral("started again")));
    EXPECT_TRUE(window_->viewport().letters().left.empty());
    // Whoever moves on tries again.
    loseDeviceAt(VulkanCall::submit, 1, 0);
    pressKey(Qt::Key_A);
    ASSERT_TRUE(waitForConverged());
    EXPECT_GT(coloursInTheMiddle(), 100);
}

TEST_F(WindowTest, ANoteOfALossLeavesAnErrorThatIsShownAlone) {
    window_->showStudy(smallStudy(Unit::hounsfield));
    ASSERT_TRUE(waitForConverged());
    window_->open("/no/such/folder");
    ASSERT_TRUE(waitUntil([&] { return !window_->message().isEmpty(); }));
    const QString error = window_->message();
    loseDeviceAt(VulkanCall::wait, 1);
    pressKey(Qt::Key_L);
    ASSERT_TRUE(waitUntil([&] { return window_->notes().contains(QStringLiteral("is started again")); }));
    EXPECT_EQ(window_->message(), error);
    ASSERT_TRUE(waitForConverged());
    EXPECT_EQ(window_->message(), error);
    EXPECT_FALSE(window_->notes().contains(QStringLiteral("is started again")));
    EXPECT_TRUE(window_->notes().contains(QStringLiteral("was started again")));
}

// As when the memory of the machine ends together with the device.
TEST_F(WindowTest, RunningOutOfMemoryOnALostDeviceIsAsGoodAsALoss) {
    window_->showStudy(smallStudy(Unit::hounsfield));
    ASSERT_TRUE(waitForConverged());
    memoryEndsAtALoss = true;
    loseDeviceAt(VulkanCall::wait, 3);
    pressKey(Qt::Key_L);
    EXPECT_TRUE(waitForConverged());
    EXPECT_FALSE(memoryEndsAtALoss) << "there was memory left";
    memoryEndsAtALoss = false;
    EXPECT_EQ(devicesLost(), 1);
}

class LossAtTheStart : public WindowTest, public testing::WithParamInterface<VulkanCall> {
  protected:
    void SetUp() override {
        loseDeviceAt(GetParam(), 1, 2);  // once more while the next one is made
        WindowTest::SetUp();
    }
};

TEST_P(LossAtTheStart, IsMadeGood) {
    window_->showStudy(smallStudy(Unit::hounsfield));
    EXPECT_TRUE(waitForConverged()) << window_->message().toStdString();
    EXPECT_EQ(devicesLost(), 2);
}

INSTANTIATE_TEST_SUITE_P(While, LossAtTheStart,
                         testing::Values(VulkanCall::create, VulkanCall::allocate, VulkanCall::compile));

}  // namespace
}  // namespace macula::viewer
