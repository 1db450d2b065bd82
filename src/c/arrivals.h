// A fetch, as a host hears of it.
#pragma once

#include <macula.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <mutex>

#include "base/progress.h"
#include "study/archive/fetched_study.h"

namespace macula::c {

// Threads that receive images, and those that report progress, may speak at the same time: a host hears one
// after the other.
class Arrivals {
  public:
    // Both have been taken from what the host gave, and live as long as this.
    Arrivals(const macula_progress& progress, const macula_fetch& fetch);
    Arrivals(const Arrivals&) = delete;
    Arrivals& operator=(const Arrivals&) = delete;

    // The host's progress, told in turn.
    const macula_progress* progress() const { return &inTurn_; }
    // Tells the host, unless it was told just now or is hearing something else: whoever receives does not
    // wait for a host. From any thread. Cancels `token` if the host wants that.
    void tell(const study::Arrival& arrival, const CancelToken& token);
    // Tells the host of what has come since.
    void tellRest(const std::filesystem::path& folder, const CancelToken& token);

  private:
    using Clock = std::chrono::steady_clock;

    static std::int32_t tellProgress(void* arrivals, const char* stage, double fraction);
    void tellNow(const study::Arrival& arrival, const CancelToken& token);

    const macula_progress& progress_;
    const macula_fetch& fetch_;
    macula_progress inTurn_{};
    std::atomic<std::size_t> most_{0};  // images, of all arrivals
    std::mutex mutex_;                  // held while the host hears
    std::size_t told_ = 0;
    Clock::time_point next_{};  // when the host hears of images again
};

}  // namespace macula::c
