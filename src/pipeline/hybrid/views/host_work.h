// The host's work on training views while the device traces the next one: a pipeline of two threads, one that
// drives the device, and one that works on the previous view.
//
//     host.advance();                  // waits for the previous view, and begins the host's work on it
//     fill(host.next());               // the device begins the next view
//     host.begun([&] { use(slot); });  // the host's work on that view, once it has arrived
//     ...
//     host.wait();
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <utility>

#include "base/aside.h"
#include "base/check.h"
#include "base/result.h"
#include "pipeline/hybrid/views/view_times.h"

namespace macula::hybrid {

// A Slot receives a view from the device, and its finish() waits for it. A slot is reused after kSlots views:
// two suffice if advance() is called before the next view is begun, three if it is called after.
template <class Slot, std::size_t kSlots>
class HostWork {
    static_assert(kSlots >= 2);

  public:
    // Adds the time of waiting for slots to `comingSeconds`, which is one of `times`.
    HostWork(double& comingSeconds, ViewTimes& times) : comingSeconds_(comingSeconds), times_(times) {}
    HostWork(const HostWork&) = delete;
    HostWork& operator=(const HostWork&) = delete;

    // The slot for the next view.
    Slot& next() { return slots_[next_]; }
    // Call when that view is on its way; `work` is done after it has arrived. Call advance() before.
    void begun(std::function<void()> work) {
        MACULA_CHECK(!work_);
        work_ = std::move(work);
        next_ = (next_ + 1) % kSlots;
    }
    // Waits for the view that was begun last, and for the work on the view before; then begins the work on
    // the last one on another thread.
    Result<void> advance() {
        if (!work_) return {};
        {
            const Lap lap(comingSeconds_);
            MACULA_TRY_VOID(slots_[(next_ + kSlots - 1) % kSlots].finish());
        }
        const Lap lap(times_.waiting);
        aside_.begin(std::exchange(work_, nullptr));
        return {};
    }
    // Waits for all views and their work.
    Result<void> wait() {
        MACULA_TRY_VOID(advance());
        const Lap lap(times_.waiting);
        aside_.wait();
        times_.beside += aside_.seconds();
        return {};
    }

  private:
    double& comingSeconds_;
    ViewTimes& times_;
    std::array<Slot, kSlots> slots_;
    std::size_t next_ = 0;        // index into slots_
    std::function<void()> work_;  // for the slot before next_
    Aside aside_;                 // last, so that it ends before what it uses is destroyed
};

}  // namespace macula::hybrid
