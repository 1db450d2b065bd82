#include "base/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace macula {

namespace {
constexpr int kBarCells = 30;
}

Progress::Listener terminalProgressBar() {
    if (isatty(STDERR_FILENO) == 0) return {};
    return [](const ProgressUpdate& update) {
        const double fraction = std::clamp(update.fraction, 0.0, 1.0);
        const int filled = static_cast<int>(fraction * kBarCells);
        const std::string line = fmt::format("\r\x1b[K{} [{:=<{}}{: <{}}] {:3.0f} %", update.stage, "",
                                             filled, "", kBarCells - filled, 100.0 * fraction);
        std::fputs(line.c_str(), stderr);
        if (fraction >= 1.0) std::fputc('\n', stderr);
        std::fflush(stderr);
    };
}

}  // namespace macula
