// What becomes of errors, exceptions and failed checks at the border to C.
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>

#include "base/no_threads.h"
#include "base/parallel.h"
#include "c/c_fixture.h"
#include "c/last_error.h"

namespace macula::test {
namespace {

TEST(CBoundary, AFailedCheckIsAnErrorWithItsWords) {
    const auto status = c::guarded([]() -> Result<void> {
        const int slices = 3;
        MACULA_CHECK_EQ(slices, 4);
        return {};
    });
    expectError(status, MACULA_FAULT);
    const std::string advice = lastError().advice;
    EXPECT_NE(advice.find("slices == 4"), std::string::npos) << advice;
    EXPECT_NE(advice.find("3 against 4"), std::string::npos) << advice;
    EXPECT_STREQ(lastError().place, "");
}

TEST(CBoundary, OnWhicheverCoreItFails) {
    expectError(c::guarded([]() -> Result<void> {
                    parallelFor(64, [](std::size_t i) { MACULA_CHECK_LT(i, 60u); });
                    return {};
                }),
                MACULA_FAULT);
}

TEST(CBoundary, NoExceptionGetsOut) {
    expectError(c::guarded([]() -> Result<void> { throw std::runtime_error("of a library"); }), MACULA_FAULT);
    expectError(c::guarded([]() -> Result<void> { throw 7; }), MACULA_FAULT);
    expectError(c::guarded([]() -> Result<void> { throw std::bad_alloc(); }), MACULA_MEMORY);
    EXPECT_EQ(c::guarded([]() -> Result<void> { return {}; }), MACULA_DONE);
    EXPECT_FALSE(CheckBoundary::isDrawn());
}

// No mistake of Macula, and nothing to report.
TEST(CBoundary, AThreadThatCannotBeMadeIsALackOfMemory) {
    const NoThreads none;
    expectError(c::guarded([]() -> Result<void> {
                    std::jthread([] {}).join();
                    return {};
                }),
                MACULA_MEMORY);
    expectError(c::guarded([]() -> Result<void> {
                    throw std::system_error(std::make_error_code(std::errc::io_error));
                }),
                MACULA_FAULT);
}

TEST(CBoundary, EachErrorHasItsStatus) {
    const auto statusOf = [](ErrorCode code) {
        return c::guarded([code]() -> Result<void> {
            return Error{code, Text("A sentence."), "a place", Text("Advice.")};
        });
    };
    EXPECT_EQ(statusOf(ErrorCode::usage), MACULA_USAGE);
    EXPECT_EQ(statusOf(ErrorCode::inputNotUsable), MACULA_INPUT);
    EXPECT_EQ(statusOf(ErrorCode::deviceNotUsable), MACULA_DEVICE);
    EXPECT_EQ(statusOf(ErrorCode::deviceLost), MACULA_DEVICE);
    EXPECT_EQ(statusOf(ErrorCode::outOfMemory), MACULA_MEMORY);
    EXPECT_EQ(statusOf(ErrorCode::outputNotWritable), MACULA_OUTPUT);
    EXPECT_EQ(statusOf(ErrorCode::archiveNotUsable), MACULA_ARCHIVE);
    EXPECT_EQ(statusOf(ErrorCode::cancelled), MACULA_CANCELLED);
    EXPECT_STREQ(lastError().message, "A sentence.");
    EXPECT_STREQ(lastError().place, "a place");
}

}  // namespace
}  // namespace macula::test
