#include "base/aside.h"

#include <chrono>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "base/check.h"
#include "base/elapsed.h"

namespace macula {

Aside::~Aside() {
    if (thread_.joinable()) thread_.join();
}

void Aside::begin(std::function<void()> work) {
    wait();
    const bool isBounded = CheckBoundary::isDrawn();
    // Shared, because a failed attempt to start the thread may have consumed its copy of the function.
    auto shared = std::make_shared<std::function<void()>>(std::move(work));
    const auto run = [this, shared, isBounded]() noexcept {
        std::optional<CheckBoundary> boundary;
        if (isBounded) boundary.emplace();
        const auto start = std::chrono::steady_clock::now();
        try {
            (*shared)();
        } catch (...) {
            thrown_ = std::current_exception();
        }
        took_ = secondsSince(start);
    };
    try {
        thread_ = std::jthread(run);
    } catch (const std::system_error&) {
        run();
    }
}

void Aside::wait() {
    if (thread_.joinable()) thread_.join();
    seconds_ += std::exchange(took_, 0.0);
    if (std::exception_ptr thrown = std::exchange(thrown_, nullptr)) std::rethrow_exception(thrown);
}

}  // namespace macula
