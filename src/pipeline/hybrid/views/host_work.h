// What the host does for training views while the device traces the next one: a pipeline of two threads, one
// that drives the device and one that works on the view before.
//
//     host.advance();                  // the view before has come; the host begins with it
//     fill(host.next());               // the device begins the next view
//     host.begun([&] { use(slot); });  // and that is to be done once it has come
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

// A Slot is what comes from the device for a view, and its finish() waits for that. A slot is taken again
// after kSlots views: two suffice where advance() comes before the next view is begun, three where it comes
// after.
template <class Slot, std::size_t kSlots>
class HostWork {
    static_assert(kSlots >= 2);

  public:
    // Waiting for slots to come counts in `comingSeconds`, which is one of `times`.
    HostWork(double& comingSeconds, ViewTimes& times) : comingSeconds_(comingSeconds), times_(times) {}
    HostWork(const HostWork&) = delete;
    HostWork& operator=(const HostWork&) = delete;

    // Where the device is to put the next view.
    Slot& next() { return slots_[next_]; }
    // That view is on its way; `work` is for when it has come. After advance().
    void begun(std::function<void()> work) {
        MACULA_CHECK(!work_);
        work_ = std::move(work);
        next_ = (next_ + 1) % kSlots;
    }
    // Waits for the view that was begun last, and for the work of the view before it; then begins its work on
    // another thread.
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
    // For all views.
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
    std::size_t next_ = 0;        // of slots_
    std::function<void()> work_;  // for the slot before it
    Aside aside_;                 // last: what it works with goes after it
};

}  // namespace macula::hybrid
