#include "live/frame/render_thread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <new>
#include <optional>
#include <thread>
#include <variant>

namespace macula::live {
namespace {

// Opens nothing: a step that comes so far is one too many.
class NoPlace final : public ScreenPlace {
  public:
    std::vector<const char*> deviceExtensions() const override { return {}; }
    Result<std::unique_ptr<Screen>> open(const std::shared_ptr<gpu::Device>&, VkExtent2D) const override {
        return Error{ErrorCode::deviceNotUsable, Text("This is no place for pictures."), {}, {}};
    }
};
std::shared_ptr<const ScreenPlace> noPlace() {
    return std::make_shared<const NoPlace>();
}

// Without a window: what a render thread must do before it has one, and after it lost it.
class RenderThreadTest : public testing::Test {
  protected:
    void SetUp() override {
        auto instance = gpu::Instance::create();
        if (!instance) FAIL() << "packaging/bootstrap installs a Vulkan driver: " << instance.error().message;
        instance_.emplace(std::move(*instance));
    }
    std::optional<gpu::Instance> instance_;
};

// However early: before its thread has begun, and while it waits for the first input.
TEST_F(RenderThreadTest, StopsWhenNothingWasPublished) {
    std::atomic<int> events = 0;
    for (int i = 0; i < 20; ++i) {
        auto instance = gpu::Instance::create();
        ASSERT_TRUE(instance.ok());
        const RenderThread thread(*std::move(instance), {}, nullptr, [&](const RenderEvent&) { ++events; });
        if (i % 2) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    EXPECT_EQ(events, 0);
}

// The user interface is not held up by a picture, however long it takes: here as long as it publishes.
TEST_F(RenderThreadTest, PublishingDoesNotWaitForAStepUnderWay) {
    std::promise<void> began;
    std::promise<void> published;
    std::atomic<int> steps = 0;
    {
        RenderThread thread(*std::move(instance_), {}, nullptr, [&](const RenderEvent& event) {
            if (!std::holds_alternative<Preparing>(event)) return;
            if (++steps == 1) {
                began.set_value();
                published.get_future().wait();
            }
            throw std::bad_alloc();  // the place below is not real, and nothing has touched it yet
        });
        const auto place = noPlace();
        thread.publish({.place = place, .width = 99, .height = 100, .visible = true});
        began.get_future().wait();
        for (int i = 0; i < 1000; ++i)
            thread.publish({.place = place, .width = 100 + i, .height = 100, .visible = true});
        EXPECT_EQ(steps, 1);
        published.set_value();
        thread.releaseScreen();
    }
    EXPECT_GE(steps, 1);
    EXPECT_LE(steps, 2);  // of a thousand inputs the last one counts
}

// Nothing of it is left when it is gone: a step under way is waited for.
TEST_F(RenderThreadTest, IsNotGoneBeforeItsStepIsOver) {
    std::promise<void> began;
    std::atomic<bool> isOver = false;
    {
        RenderThread thread(*std::move(instance_), {}, nullptr, [&](const RenderEvent& event) {
            if (!std::holds_alternative<Preparing>(event)) return;
            began.set_value();
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
            isOver = true;
            throw std::bad_alloc();  // as above
        });
        thread.publish({.place = noPlace(), .width = 100, .height = 100, .visible = true});
        began.get_future().wait();
    }
    EXPECT_TRUE(isOver);
}

TEST_F(RenderThreadTest, WithoutAPlaceNothingIsDone) {
    std::atomic<int> events = 0;
    {
        RenderThread thread(*std::move(instance_), {}, nullptr, [&](const RenderEvent&) { ++events; });
        std::uint64_t last = 0;
        for (int i = 0; i < 1000; ++i) {
            const std::uint64_t sequence = thread.publish({.width = 100 + i, .height = 100, .visible = true});
            EXPECT_GT(sequence, last);
            last = sequence;
        }
        thread.releaseScreen();  // there is none to wait for
    }
    EXPECT_EQ(events, 0);
}

// Preparing is the first thing a step tells, so that a listener which throws there stands for any part of the
// step that runs out of memory; nothing has touched the place by then, and this one is not real.
TEST_F(RenderThreadTest, RunningOutOfMemoryIsToldAndTheThreadLivesOn) {
    std::atomic<int> failures = 0;
    std::atomic<bool> outOfMemory = true;
    {
        RenderThread thread(*std::move(instance_), {}, nullptr, [&](const RenderEvent& event) {
            if (std::holds_alternative<Preparing>(event)) throw std::bad_alloc();
            if (const auto* failure = std::get_if<RenderFailure>(&event)) {
                outOfMemory = outOfMemory && failure->error.code == ErrorCode::outOfMemory;
                ++failures;
            }
        });
        const auto place = noPlace();
        for (int i = 1; i <= 2; ++i) {
            thread.publish({.place = place, .width = 100 + i, .height = 100, .visible = true});
            const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(8);
            while (failures < i && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
            ASSERT_EQ(failures, i);
        }
        thread.releaseScreen();
    }
    EXPECT_EQ(failures, 2);
    EXPECT_TRUE(outOfMemory);
}

}  // namespace
}  // namespace macula::live
