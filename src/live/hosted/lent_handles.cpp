#include "live/hosted/lent_handles.h"

#include <memory>
#include <mutex>
#include <utility>

namespace macula::live {

namespace {

class GuardOfHost final : public gpu::QueueGuard {
  public:
    GuardOfHost(std::function<void()> lock, std::function<void()> unlock)
        : lock_(std::move(lock)), unlock_(std::move(unlock)) {}
    void lock() override { lock_(); }
    void unlock() override { unlock_(); }

  private:
    std::function<void()> lock_;
    std::function<void()> unlock_;
};

// For a host that does not use the queue meanwhile. Several handles of Macula may use it, on different
// threads.
class OwnGuard final : public gpu::QueueGuard {
  public:
    void lock() override { mutex_.lock(); }
    void unlock() override { mutex_.unlock(); }

  private:
    std::mutex mutex_;
};

std::shared_ptr<gpu::QueueGuard> guardOf(const LentHandles& lent) {
    if (lent.lock) return std::make_shared<GuardOfHost>(lent.lock, lent.unlock);
    return std::make_shared<OwnGuard>();
}

}  // namespace

Result<DeviceWay> lentWay(const LentHandles& lent) {
    if (lent.instance == nullptr || lent.physical == nullptr || lent.device == nullptr ||
        lent.queue == nullptr)
        return Error{ErrorCode::usage,
                     Text("A handle of the graphics device that is lent is missing."),
                     {},
                     Text("Give VkInstance, VkPhysicalDevice, VkDevice, and a VkQueue of it with compute.")};
    if (bool(lent.lock) != bool(lent.unlock))
        return Error{ErrorCode::usage,
                     Text("The queue that is lent can be locked, or unlocked, but not both."),
                     {},
                     Text("Give both functions, or neither.")};
    DeviceWay way;
    way.instance.lent = static_cast<VkInstance>(lent.instance);
    way.device.physical = static_cast<VkPhysicalDevice>(lent.physical);
    way.device.lent = gpu::LentDevice{.handle = static_cast<VkDevice>(lent.device),
                                      .queue = static_cast<VkQueue>(lent.queue),
                                      .queueFamily = lent.queueFamily,
                                      .guard = guardOf(lent)};
    return way;
}

}  // namespace macula::live
