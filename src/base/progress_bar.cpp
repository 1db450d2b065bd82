#include "base/progress_bar.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "base/elapsed.h"

namespace macula {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kMostCells = 30;
constexpr int kFewestCells = 6;  // a shorter bar would add nothing to the percentage
constexpr std::chrono::seconds kLineInterval{10};

bool isLiveTerminal() {
    const char* terminal = std::getenv("TERM");
    return isatty(STDERR_FILENO) != 0 && std::string_view(terminal ? terminal : "") != "dumb";
}

int columnsOfTerminal() {
    winsize size{};
    const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return known ? size.ws_col : 80;
}

std::string timeLeft(double seconds) {
    if (seconds < 0.0) return {};
    if (seconds < 100.0) return fmt::format(", {:.0f} s left", std::ceil(seconds));
    if (seconds < 6000.0) return fmt::format(", {:.0f} min left", std::ceil(seconds / 60.0));
    return fmt::format(", {:.0f} h left", std::ceil(seconds / 3600.0));
}

// Estimates the time left of a stage from its progress so far; unknown (-1) in its first second and first
// percent.
class Estimate {
  public:
    double secondsLeft(const ProgressUpdate& update) {
        if (!(update.stage == stage_) || update.fraction < fraction_) {
            stage_ = update.stage;
            start_ = Clock::now();
            first_ = update.fraction;
        }
        fraction_ = update.fraction;
        const double seconds = secondsSince(start_);
        const double done = fraction_ - first_;
        if (seconds < 1.0 || done < 0.01 || fraction_ >= 1.0) return -1.0;
        return seconds * (1.0 - fraction_) / done;
    }

  private:
    Text stage_;
    double fraction_ = 0.0;
    double first_ = 0.0;
    Clock::time_point start_;
};

}  // namespace

std::string progressLine(const ProgressUpdate& update, double secondsLeft, int columns) {
    const double fraction = std::clamp(update.fraction, 0.0, 1.0);
    const std::string end = fmt::format(" {:3.0f} %{}", 100.0 * fraction, timeLeft(secondsLeft));
    const int room = std::max(columns - static_cast<int>(end.size()), 1);
    std::string line = update.stage.english().substr(0, static_cast<std::size_t>(room));  // stages are ASCII
    const int cells = std::min(room - static_cast<int>(line.size()) - 3, kMostCells);
    if (cells >= kFewestCells) {
        const int filled = static_cast<int>(fraction * cells);
        line += fmt::format(" [{:=<{}}{: <{}}]", "", filled, "", cells - filled);
    }
    return line + end;
}

Progress::Listener terminalProgressBar() {
    if (isLiveTerminal()) {
        return [estimate = Estimate()](const ProgressUpdate& update) mutable {
            // The last column stays free, because some terminals wrap there.
            const std::string line =
                "\r\x1b[K" + progressLine(update, estimate.secondsLeft(update), columnsOfTerminal() - 1);
            std::fputs(line.c_str(), stderr);
            if (update.fraction >= 1.0) std::fputc('\n', stderr);
            std::fflush(stderr);
        };
    }
    return [estimate = Estimate(), last = Clock::now()](const ProgressUpdate& update) mutable {
        const double left = estimate.secondsLeft(update);
        if (Clock::now() - last < kLineInterval) return;
        last = Clock::now();
        const std::string line =
            fmt::format("{}: {:.0f} %{}\n", update.stage.english(), 100.0 * update.fraction, timeLeft(left));
        std::fputs(line.c_str(), stderr);
        std::fflush(stderr);
    };
}

void clearProgressBar() {
    if (isLiveTerminal()) std::fputs("\r\x1b[K", stderr);
}

}  // namespace macula
