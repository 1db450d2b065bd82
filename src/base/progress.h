// Progress and cancellation of anything that takes longer than 100 ms.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>

#include "base/text.h"

namespace macula {

// A cancellation flag, shared by all copies of the token. Thread-safe.
class CancelToken {
  public:
    void cancel() const { flag_->store(true, std::memory_order_relaxed); }
    bool cancelled() const { return flag_->load(std::memory_order_relaxed); }

  private:
    std::shared_ptr<std::atomic<bool>> flag_ = std::make_shared<std::atomic<bool>>(false);
};

struct ProgressUpdate {
    Text stage;             // what is being done, for a person: "Reading 248 files". No patient data.
    double fraction = 0.0;  // 0 to 1, of this stage
};

// Passed down into a job by reference. Calls the listener at most 10 times a second, plus once at the start
// and once at the end of each stage, from whichever thread advances; calls never overlap. Thread-safe.
class Progress {
  public:
    using Listener = std::function<void(const ProgressUpdate&)>;

    Progress() = default;
    explicit Progress(Listener listener, CancelToken token = {});

    void beginStage(Text stage, std::size_t steps);
    void advance(std::size_t steps = 1);
    bool cancelled() const { return token_.cancelled(); }
    const CancelToken& token() const { return token_; }

  private:
    using Clock = std::chrono::steady_clock;

    void report(std::size_t done, std::size_t total);

    Listener listener_;
    CancelToken token_;
    std::mutex mutex_;
    Text stage_;
    std::atomic<std::size_t> done_{0};
    std::atomic<std::size_t> total_{1};
    Clock::time_point lastReport_{};
};

}  // namespace macula
