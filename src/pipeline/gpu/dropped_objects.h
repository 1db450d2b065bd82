// Keeps Vulkan objects that have no owner any more until the device is done with them.
#pragma once

#include <vulkan/vulkan_core.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

#include "pipeline/gpu/handle.h"
#include "pipeline/gpu/ticket.h"

namespace macula::gpu {

// Thread-safe: resources are dropped on any thread. `submitted` is the device's last submission, read while
// no recorder can open or close.
class DroppedObjects {
  public:
    void add(DestroyFunction destroy, std::uint64_t object, const std::atomic<Ticket>& submitted);
    // While a recorder is open, it may have recorded a use of a dropped object, and its submission has no
    // ticket yet.
    void recorderOpened();
    void recorderClosed(const std::atomic<Ticket>& submitted);

    // Destroys the objects that no submission after `completed` uses, in the order in which they were
    // dropped: views before images.
    void destroyDone(VkDevice device, Ticket completed);
    void destroyAll(VkDevice device);  // once the device is idle
    std::size_t count() const;

  private:
    struct Dropped {
        DestroyFunction destroy = nullptr;
        std::uint64_t object = 0;
        Ticket after = 0;
    };
    static constexpr Ticket kNotYetKnown = UINT64_MAX;  // dropped while a recorder is open

    mutable std::mutex mutex_;
    std::vector<Dropped> dropped_;
    std::size_t openRecorders_ = 0;
};

}  // namespace macula::gpu
