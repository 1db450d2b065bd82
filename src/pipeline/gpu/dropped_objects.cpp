#include "pipeline/gpu/dropped_objects.h"

#include <algorithm>

#include "base/check.h"

namespace macula::gpu {

void DroppedObjects::add(DestroyFunction destroy, std::uint64_t object,
                         const std::atomic<Ticket>& submitted) {
    const std::lock_guard lock(mutex_);
    dropped_.push_back({destroy, object, openRecorders_ > 0 ? kNotYetKnown : submitted.load()});
}

void DroppedObjects::recorderOpened() {
    const std::lock_guard lock(mutex_);
    ++openRecorders_;
}

void DroppedObjects::recorderClosed(const std::atomic<Ticket>& submitted) {
    const std::lock_guard lock(mutex_);
    MACULA_CHECK(openRecorders_ > 0);
    if (--openRecorders_ > 0) return;
    for (Dropped& dropped : dropped_)
        if (dropped.after == kNotYetKnown) dropped.after = submitted.load();
}

void DroppedObjects::destroyDone(VkDevice device, Ticket completed) {
    std::vector<Dropped> due;
    {
        const std::lock_guard lock(mutex_);
        const auto firstKept =
            std::stable_partition(dropped_.begin(), dropped_.end(),
                                  [&](const Dropped& dropped) { return dropped.after <= completed; });
        due.assign(dropped_.begin(), firstKept);
        dropped_.erase(dropped_.begin(), firstKept);
    }
    for (const Dropped& dropped : due) dropped.destroy(device, dropped.object);
}

void DroppedObjects::destroyAll(VkDevice device) {
    for (const Dropped& dropped : dropped_) dropped.destroy(device, dropped.object);
}

std::size_t DroppedObjects::count() const {
    const std::lock_guard lock(mutex_);
    return dropped_.size();
}

}  // namespace macula::gpu
