// A mailbox with one slot: a new value replaces one that was not taken yet.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <utility>

namespace macula::live {

// Any thread may publish, one thread takes. Publishing never waits for the taker: the lock is held only to
// move a value in or out, never to make, use or destroy one.
template <class T>
class Latest {
  public:
    void publish(T value) {
        std::optional<T> replaced(std::move(value));
        {
            const std::lock_guard lock(mutex_);
            std::swap(slot_, replaced);
            pending_.store(true, std::memory_order_release);
        }
        wake_.notify_one();
    }

    // From now on takers do not wait: they get the value in the slot, or nothing.
    void close() {
        {
            const std::lock_guard lock(mutex_);
            closed_ = true;
        }
        wake_.notify_all();
    }

    // Whether a value waits to be taken. Takes no lock, so it is cheap enough for an inner loop.
    bool pending() const { return pending_.load(std::memory_order_acquire); }

    std::optional<T> tryTake() {
        if (!pending()) return std::nullopt;
        const std::lock_guard lock(mutex_);
        return unload();
    }

    // Waits for a value. Returns nothing once closed and empty.
    std::optional<T> take() {
        std::unique_lock lock(mutex_);
        wake_.wait(lock, [this] { return slot_.has_value() || closed_; });
        return unload();
    }

    // Like take(), but also returns nothing after `timeout`.
    std::optional<T> takeFor(std::chrono::milliseconds timeout) {
        std::unique_lock lock(mutex_);
        wake_.wait_for(lock, timeout, [this] { return slot_.has_value() || closed_; });
        return unload();
    }

  private:
    std::optional<T> unload() {
        pending_.store(false, std::memory_order_release);
        return std::exchange(slot_, std::nullopt);
    }

    std::mutex mutex_;
    std::condition_variable wake_;
    std::optional<T> slot_;
    std::atomic<bool> pending_{false};
    bool closed_ = false;
};

}  // namespace macula::live
