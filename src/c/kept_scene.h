// The scene of a view's last picture, which stays on the device for the next one: to draw the same volume
// again, only what has changed is brought to the device.
#pragma once

#include <memory>
#include <mutex>
#include <optional>

#include "pictures/drawn_picture.h"

namespace macula::c {

// Each view has one, which ends with the view.
class KeptScene {
  public:
    // Calls use(std::optional<pictures::PictureDrawer>&) with what the last picture left on that device:
    // nothing if it was drawn on another. Only for a call that has both the device and the view to itself.
    template <class Use>
    auto use(const void* device, const Use& use) {
        {
            const std::scoped_lock lock(mutex_);
            if (device_ != device) drawer_.reset();
            device_ = device;
        }
        return use(drawer_);
    }
    // Only for a call that has that device to itself, so that nobody uses what is on it.
    void dropFrom(const void* device) {
        const std::scoped_lock lock(mutex_);
        if (device_ == device) drawer_.reset();
    }

  private:
    std::mutex mutex_;  // guards the hand-over from device to device; see use()
    const void* device_ = nullptr;
    std::optional<pictures::PictureDrawer> drawer_;
};

// A device keeps the scene of one view at a time, so that it never holds more than one picture needed. The
// device's end drops the scene as well, because a host may have lent the device.
class LastScene {
  public:
    LastScene() = default;
    LastScene(const LastScene&) = delete;
    LastScene& operator=(const LastScene&) = delete;
    ~LastScene() { be(nullptr); }

    void be(const std::shared_ptr<KeptScene>& scene) {
        const std::shared_ptr<KeptScene> before = last_.lock();
        if (before && before != scene) before->dropFrom(this);
        last_ = scene;
    }

  private:
    std::weak_ptr<KeptScene> last_;
};

}  // namespace macula::c
