// Work beside the thread that asks for it.
#include "base/aside.h"

#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include "base/check.h"
#include "base/no_threads.h"
#include "base/parallel.h"

namespace macula {
namespace {

using namespace std::chrono_literals;

TEST(Aside, IsDoneInOrderAndSeenAfterwards) {
    Aside aside;
    std::vector<int> done;
    const std::thread::id here = std::this_thread::get_id();
    for (int i = 0; i < 50; ++i) {
        aside.begin([&done, i, here] {
            EXPECT_NE(std::this_thread::get_id(), here);
            done.push_back(i);
        });
    }
    aside.wait();
    aside.wait();  // nothing is left
    ASSERT_EQ(done.size(), 50u);
    for (int i = 0; i < 50; ++i) EXPECT_EQ(done[std::size_t(i)], i);
}

TEST(Aside, MayTakeAllCores) {
    Aside aside;
    std::vector<int> squares(1000);
    aside.begin([&] { parallelFor(1000, [&](std::size_t i) { squares[i] = int(i * i); }); });
    aside.wait();
    for (std::size_t i = 0; i < squares.size(); ++i) EXPECT_EQ(squares[i], int(i * i));
}

TEST(Aside, DoesItHereWhereThereIsNoThread) {
    const test::NoThreads none;
    Aside aside;
    std::thread::id by;
    aside.begin([&] { by = std::this_thread::get_id(); });
    aside.wait();
    EXPECT_EQ(by, std::this_thread::get_id());
    aside.begin([] { throw std::runtime_error("here too"); });
    EXPECT_THROW(aside.wait(), std::runtime_error);
}

TEST(Aside, CountsItsTime) {
    Aside aside;
    EXPECT_EQ(aside.seconds(), 0.0);
    aside.begin([] { std::this_thread::sleep_for(5ms); });
    aside.begin([] { std::this_thread::sleep_for(5ms); });
    aside.wait();
    EXPECT_GE(aside.seconds(), 0.01);
}

TEST(Aside, ThrowsWhatItsWorkThrew) {
    Aside aside;
    aside.begin([] { throw std::runtime_error("first"); });
    bool wasBegun = false;
    EXPECT_THROW(aside.begin([&] { wasBegun = true; }), std::runtime_error);
    EXPECT_FALSE(wasBegun);
    aside.wait();  // it was told once
    aside.begin([] { throw std::runtime_error("second"); });
    EXPECT_THROW(aside.wait(), std::runtime_error);
    aside.begin([&] { wasBegun = true; });
    aside.wait();
    EXPECT_TRUE(wasBegun);
}

TEST(Aside, IsWithinTheBoundaryOfWhoBeganIt) {
    const CheckBoundary boundary;
    Aside aside;
    aside.begin([] { MACULA_CHECK(1 > 2); });
    EXPECT_THROW(aside.wait(), CheckFailure);
}

TEST(Aside, IsWaitedForWhereItIsDropped) {
    bool isDone = false;
    {
        Aside aside;
        aside.begin([&] {
            std::this_thread::sleep_for(5ms);
            isDone = true;
        });
    }
    EXPECT_TRUE(isDone);
    Aside never;
    {
        Aside failing;
        failing.begin([] { throw std::runtime_error("nobody asks"); });
    }
}

}  // namespace
}  // namespace macula
