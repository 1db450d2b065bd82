// A failed check: it ends the program, or reaches the boundary that somebody has drawn.
#include "base/check.h"

#include <gtest/gtest.h>

#include <atomic>
#include <exception>
#include <string>
#include <thread>

#include "base/parallel.h"

namespace macula {
namespace {

std::string textOfFailure(int a, int b) {
    const CheckBoundary boundary;
    try {
        MACULA_CHECK_EQ(a, b);
    } catch (const CheckFailure& failure) {
        return failure.text();
    }
    return {};
}

TEST(Check, WithinABoundaryItIsThrownWithItsWords) {
    EXPECT_EQ(textOfFailure(3, 3), "");
    const std::string text = textOfFailure(3, 4);
    EXPECT_NE(text.find("check_test.cpp:"), std::string::npos) << text;
    EXPECT_NE(text.find("a == b"), std::string::npos) << text;
    EXPECT_NE(text.find("3 against 4"), std::string::npos) << text;
    EXPECT_FALSE(CheckBoundary::isDrawn());
}

// Rooms stop exceptions of libraries by that name.
TEST(Check, IsNotStoppedAsAnExceptionOfALibrary) {
    const CheckBoundary boundary;
    bool passed = false;
    try {
        try {
            MACULA_CHECK(1 > 2);
        } catch (const std::exception&) {
            ADD_FAILURE() << "stopped on the way";
        }
    } catch (const CheckFailure&) {
        passed = true;
    }
    EXPECT_TRUE(passed);
}

TEST(Check, ABoundaryHoldsForAllCoresThatWorkForIt) {
    const CheckBoundary boundary;
    std::atomic<int> bounded = 0;
    parallelFor(64, [&](std::size_t) { bounded += CheckBoundary::isDrawn() ? 1 : 0; });
    EXPECT_EQ(bounded, 64);
    EXPECT_THROW(parallelFor(64, [](std::size_t i) { MACULA_CHECK_LT(i, 40u); }), CheckFailure);
}

TEST(Check, ABoundaryIsOfItsThreadAlone) {
    const CheckBoundary boundary;
    bool isDrawn = true;
    std::thread([&] { isDrawn = CheckBoundary::isDrawn(); }).join();
    EXPECT_FALSE(isDrawn);
}

TEST(CheckDeathTest, WithoutABoundaryItEndsTheProgram) {
    const int a = 3;
    EXPECT_DEATH(MACULA_CHECK_EQ(a, 4), "check failed: a == 4: 3 against 4");
}

// Two exceptions at once would end it without a word.
TEST(CheckDeathTest, WhileSomethingIsThrownItEndsTheProgramWithItsWords) {
    struct FailsAtItsEnd {
        FailsAtItsEnd() = default;
        FailsAtItsEnd(const FailsAtItsEnd&) = delete;
        FailsAtItsEnd& operator=(const FailsAtItsEnd&) = delete;
        ~FailsAtItsEnd() { MACULA_CHECK(2 > 3); }
    };
    const CheckBoundary boundary;
    const auto fail = [] {
        const FailsAtItsEnd last;
        MACULA_CHECK(1 > 2);
    };
    EXPECT_DEATH(fail(), "check failed: 2 > 3");
}

}  // namespace
}  // namespace macula
