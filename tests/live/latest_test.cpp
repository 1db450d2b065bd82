#include "live/frame/latest.h"

#include <gtest/gtest.h>

#include <memory>
#include <thread>
#include <vector>

namespace macula::live {
namespace {

using std::chrono::milliseconds;

TEST(Latest, TheNewestValueWins) {
    Latest<int> slot;
    EXPECT_FALSE(slot.pending());
    EXPECT_FALSE(slot.tryTake().has_value());
    slot.publish(1);
    slot.publish(2);
    EXPECT_TRUE(slot.pending());
    EXPECT_EQ(slot.take(), 2);
    EXPECT_FALSE(slot.pending());
    EXPECT_FALSE(slot.tryTake().has_value());
}

TEST(Latest, AReplacedValueIsDestroyedAtOnce) {
    Latest<std::shared_ptr<int>> slot;
    auto first = std::make_shared<int>(1);
    const std::weak_ptr<int> seen = first;
    slot.publish(std::move(first));
    slot.publish(std::make_shared<int>(2));
    EXPECT_TRUE(seen.expired());
}

TEST(Latest, WaitingEndsWithTheTimeoutOrTheEnd) {
    Latest<int> slot;
    EXPECT_FALSE(slot.takeFor(milliseconds(5)).has_value());
    std::jthread closer([&] {
        std::this_thread::sleep_for(milliseconds(10));
        slot.close();
    });
    EXPECT_FALSE(slot.take().has_value());
    slot.publish(3);
    EXPECT_EQ(slot.take(), 3);  // what was published is not lost by closing
}

// One thread publishes as fast as it can; the taker sees only growing values, and always the last.
TEST(Latest, NothingComesOutOfOrderAndTheLastIsNeverLost) {
    constexpr int kCount = 200'000;
    for (int round = 0; round < 5; ++round) {
        Latest<std::vector<int>> slot;  // large enough to be torn, were it possible
        std::jthread producer([&] {
            for (int i = 1; i <= kCount / 10; ++i) slot.publish(std::vector<int>(8, i));
        });
        int last = 0;
        while (last < kCount / 10) {
            const auto value = slot.take();
            ASSERT_TRUE(value.has_value());
            ASSERT_GT(value->front(), last);
            ASSERT_EQ(value->front(), value->back());
            last = value->front();
        }
    }
}

}  // namespace
}  // namespace macula::live
