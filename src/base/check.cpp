#include "base/check.h"

#include <cstdio>
#include <cstdlib>
#include <exception>

namespace macula {

namespace {

thread_local int boundaries = 0;

}  // namespace

CheckBoundary::CheckBoundary() noexcept {
    ++boundaries;
}

CheckBoundary::~CheckBoundary() {
    --boundaries;
}

bool CheckBoundary::isDrawn() noexcept {
    return boundaries > 0;
}

void checkFailed(const char* file, int line, const char* what, const std::string& values) {
    // A second exception in flight would end the program without a message.
    if (CheckBoundary::isDrawn() && std::uncaught_exceptions() == 0)
        throw CheckFailure(
            fmt::format("{}:{}: {}{}{}", file, line, what, values.empty() ? "" : ": ", values));
    std::fprintf(stderr, "%s:%d: check failed: %s%s%s\n", file, line, what, values.empty() ? "" : ": ",
                 values.c_str());
    std::fflush(stderr);
    std::abort();
}

}  // namespace macula
