#include "viewer/render_thread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <optional>

namespace macula::viewer {
namespace {

// Without a window: what a render thread must do before it has one, and after it lost it.
class RenderThreadTest : public testing::Test {
  protected:
    void SetUp() override {
        auto instance = gpu::Instance::create();
        if (!instance) GTEST_SKIP() << "No Vulkan here: " << instance.error().message;
        instance_.emplace(std::move(*instance));
    }
    std::optional<gpu::Instance> instance_;
};

TEST_F(RenderThreadTest, StopsAtOnceWhenNothingWasPublished) {
    const RenderThread thread(*std::move(instance_), {}, [](const RenderEvent&) {});
}

TEST_F(RenderThreadTest, WithoutASurfaceNothingIsDone) {
    std::atomic<int> events = 0;
    {
        RenderThread thread(*std::move(instance_), {}, [&](const RenderEvent&) { ++events; });
        std::uint64_t last = 0;
        for (int i = 0; i < 1000; ++i) {
            const std::uint64_t sequence = thread.publish({.width = 100 + i, .height = 100, .visible = true});
            EXPECT_GT(sequence, last);
            last = sequence;
        }
        EXPECT_TRUE(thread.releaseSurface(std::chrono::milliseconds(1)));  // there is none to wait for
    }
    EXPECT_EQ(events, 0);
}

}  // namespace
}  // namespace macula::viewer
