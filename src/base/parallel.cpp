#include "base/parallel.h"

#include <exception>
#include <optional>
#include <thread>
#include <vector>

#include "base/check.h"
#include "base/process_limits.h"

namespace macula {

namespace {

// Keeps the first exception of any thread, which ends the work of all threads.
class FirstException {
  public:
    void keepCurrent() {
        if (!thrown_.exchange(true)) exception_ = std::current_exception();
    }
    bool thrown() const { return thrown_; }
    // Call once all threads are done.
    void rethrow() const {
        if (exception_) std::rethrow_exception(exception_);
    }

  private:
    std::atomic<bool> thrown_{false};
    std::exception_ptr exception_;
};

}  // namespace

std::size_t coreCount() {
    static const std::size_t count = usableProcessors();  // cached, because it reads files of /proc and /sys
    return count;
}

void parallelFor(std::size_t count, const std::function<void(std::size_t)>& body, const CancelToken& token) {
    std::atomic<std::size_t> next{0};
    FirstException first;
    const bool isBounded = CheckBoundary::isDrawn();
    const auto work = [&]() noexcept {
        std::optional<CheckBoundary> boundary;
        if (isBounded) boundary.emplace();
        try {
            for (std::size_t i = next++; i < count && !token.cancelled() && !first.thrown(); i = next++)
                body(i);
        } catch (...) {
            first.keepCurrent();
        }
    };
    {
        const std::size_t wanted = std::min(coreCount(), std::max<std::size_t>(count, 1)) - 1;
        std::vector<std::jthread> helpers;
        try {
            helpers.reserve(wanted);
            while (helpers.size() < wanted) helpers.emplace_back(work);
        } catch (const std::exception&) {
            // The process has no memory or threads left: the existing threads do all of the work. oneTBB
            // (2021.8) would throw instead, with nothing done.
        }
        work();
    }
    first.rethrow();
}

}  // namespace macula
