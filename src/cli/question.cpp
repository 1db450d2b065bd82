#include "cli/question.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>

#include "base/parsing.h"
#include "base/progress_bar.h"
#include "cli/shared/interrupt.h"

namespace macula::cli {

namespace {

constexpr int kLookMs = 100;  // how long the token is not looked at

// False at the end of the input.
Result<bool> waitForInput() {
    for (pollfd input{STDIN_FILENO, POLLIN, 0};;) {
        if (interruptToken().cancelled()) return Error{ErrorCode::cancelled, Text("Stopped."), {}, {}};
        const int ready = poll(&input, 1, kLookMs);
        if (ready > 0) return (input.revents & POLLIN) != 0;
        if (ready < 0 && errno != EINTR) return false;
    }
}

}  // namespace

bool canAsk() {
    return isatty(STDIN_FILENO) != 0 && isatty(STDERR_FILENO) != 0;
}

Result<bool> ask(std::string_view question) {
    clearProgressBar();
    std::fputs(fmt::format("{} [y/N] ", question).c_str(), stderr);
    std::fflush(stderr);
    const auto isThere = waitForInput();
    if (!isThere) {
        std::fputc('\n', stderr);
        return isThere.error();
    }
    std::array<char, 256> line{};
    const ssize_t count = isThere.value() ? read(STDIN_FILENO, line.data(), line.size()) : 0;
    const std::string_view answer = trimmed({line.data(), static_cast<std::size_t>(count > 0 ? count : 0)});
    return answer == "y" || answer == "Y" || answer == "yes" || answer == "Yes" || answer == "YES";
}

}  // namespace macula::cli
