#include "viewer/driven/ui_heartbeat.h"

#include <ctime>
#include <utility>

namespace macula::viewer {

namespace {
constexpr int kIntervalMs = 5;

double ownWorkMs() {
#ifdef __linux__
    timespec worked{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &worked);
    return 1e3 * double(worked.tv_sec) + 1e-6 * double(worked.tv_nsec);
#else
    return 0.0;
#endif
}

}  // namespace

UiHeartbeat::UiHeartbeat(QObject* parent) : QObject(parent) {
    timer_.setTimerType(Qt::PreciseTimer);
    timer_.setInterval(kIntervalMs);
    connect(&timer_, &QTimer::timeout, this, &UiHeartbeat::beat);
}

void UiHeartbeat::start() {
    longestMs_ = 0.0;
    ownWorkInItMs_ = 0.0;
    ownWorkMs_ = ownWorkMs();
    noticed_ = 0;
    beats_ = 0;
    sinceLast_.start();
    timer_.start();
}

void UiHeartbeat::stop() {
    beat();  // a stall at the very end counts
    timer_.stop();
}

void UiHeartbeat::beat() {
    const double gapMs = double(sinceLast_.nsecsElapsed()) / 1e6;
    sinceLast_.start();
    const double workedBefore = std::exchange(ownWorkMs_, ownWorkMs());
    if (gapMs - kIntervalMs > longestMs_) {
        longestMs_ = gapMs - kIntervalMs;
        ownWorkInItMs_ = ownWorkMs_ - workedBefore;
    }
    if (gapMs - kIntervalMs > kNoticedMs) ++noticed_;
    ++beats_;
}

}  // namespace macula::viewer
