// A process that gets no more threads.
#pragma once

#include <gtest/gtest.h>
#include <pthread.h>

#include <cstddef>

namespace macula::test {

// While one lives, no thread can be made that says nothing about its stack, so none of std::thread and
// std::jthread: each would have a stack larger than all addresses. Those that are there go on.
class NoThreads {
  public:
    NoThreads() {
        constexpr std::size_t kTooLarge = std::size_t{1} << 47;
        pthread_attr_t none;
        EXPECT_EQ(pthread_getattr_default_np(&before_), 0);
        EXPECT_EQ(pthread_attr_init(&none), 0);
        EXPECT_EQ(pthread_attr_setstacksize(&none, kTooLarge), 0);
        EXPECT_EQ(pthread_setattr_default_np(&none), 0);
        pthread_attr_destroy(&none);
    }
    NoThreads(const NoThreads&) = delete;
    NoThreads& operator=(const NoThreads&) = delete;
    ~NoThreads() {
        EXPECT_EQ(pthread_setattr_default_np(&before_), 0);
        pthread_attr_destroy(&before_);
    }

  private:
    pthread_attr_t before_{};
};

}  // namespace macula::test
