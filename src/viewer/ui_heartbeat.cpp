#include "viewer/ui_heartbeat.h"

#include <algorithm>

namespace macula::viewer {

namespace {
constexpr int kIntervalMs = 5;
}

UiHeartbeat::UiHeartbeat(QObject* parent) : QObject(parent) {
    timer_.setTimerType(Qt::PreciseTimer);
    timer_.setInterval(kIntervalMs);
    connect(&timer_, &QTimer::timeout, this, &UiHeartbeat::beat);
}

void UiHeartbeat::start() {
    longestMs_ = 0.0;
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
    longestMs_ = std::max(longestMs_, gapMs - kIntervalMs);
    if (gapMs - kIntervalMs > kNoticedMs) ++noticed_;
    ++beats_;
}

}  // namespace macula::viewer
