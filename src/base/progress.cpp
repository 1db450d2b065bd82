#include "base/progress.h"

#include <algorithm>

namespace macula {

namespace {
constexpr std::chrono::milliseconds kReportInterval{100};
}

Progress::Progress(Listener listener, CancelToken token)
    : listener_(std::move(listener)), token_(std::move(token)) {}

void Progress::beginStage(Text stage, std::size_t steps) {
    const std::lock_guard lock(mutex_);
    stage_ = std::move(stage);
    total_ = std::max<std::size_t>(steps, 1);
    done_ = 0;
    report(0, total_);
}

void Progress::advance(std::size_t steps) {
    const std::size_t done = done_.fetch_add(steps) + steps;
    if (!listener_) return;
    const std::size_t total = total_;
    const bool last = done >= total;
    std::unique_lock lock(mutex_, std::defer_lock);
    if (last) {
        lock.lock();
    } else if (!lock.try_lock() || Clock::now() - lastReport_ < kReportInterval) {
        return;  // another thread is reporting, or has just done so
    }
    report(std::min(done, total), total);
}

void Progress::report(std::size_t done, std::size_t total) {
    if (!listener_) return;
    lastReport_ = Clock::now();
    listener_({stage_, static_cast<double>(done) / static_cast<double>(total)});
}

}  // namespace macula
