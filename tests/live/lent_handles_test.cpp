// What a host lends of its Vulkan.
#include "live/hosted/lent_handles.h"

#include <gtest/gtest.h>

namespace macula::live {
namespace {

LentHandles handles() {
    static int something = 0;  // nobody looks into them
    LentHandles lent;
    lent.instance = lent.physical = lent.device = lent.queue = &something;
    return lent;
}

TEST(LentHandles, TheLockOfTheHostIsUsed) {
    int held = 0;
    LentHandles lent = handles();
    lent.lock = [&] { ++held; };
    lent.unlock = [&] { --held; };
    const Result<DeviceWay> way = lentWay(lent);
    ASSERT_TRUE(way.ok());
    way->device.lent->guard->lock();
    EXPECT_EQ(held, 1);
    way->device.lent->guard->unlock();
    EXPECT_EQ(held, 0);
    lent.unlock = nullptr;
    EXPECT_FALSE(lentWay(lent).ok());
}

// Different handles are used by different threads at once, and have one queue.
TEST(LentHandles, WithoutALockOfTheHostAllShareOneOfTheirOwn) {
    const Result<DeviceWay> way = lentWay(handles());
    ASSERT_TRUE(way.ok());
    ASSERT_NE(way->device.lent->guard, nullptr);
    const DeviceWay ofAnother = *way;
    EXPECT_EQ(ofAnother.device.lent->guard, way->device.lent->guard);
}

TEST(LentHandles, OneThatIsMissingIsRefused) {
    LentHandles lent = handles();
    lent.queue = nullptr;
    const Result<DeviceWay> way = lentWay(lent);
    ASSERT_FALSE(way.ok());
    EXPECT_EQ(way.error().code, ErrorCode::usage);
}

}  // namespace
}  // namespace macula::live
