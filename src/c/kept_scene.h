// The scene of a view's last picture, which stays on the device for the next one: to draw the same volume
// again, a device is brought only what has changed.
#pragma once

#include <memory>
#include <mutex>
#include <optional>

#include "pictures/drawn_picture.h"

namespace macula::c {

// A view has one. It ends with the view.
class KeptScene {
  public:
    // Calls use(std::optional<pictures::PictureDrawer>&) with what the last picture has left on that device,
    // nothing where it was drawn on another. By the one who has the device and the view for itself.
    template <class Use>
    auto use(const void* device, const Use& use) {
        {
            const std::scoped_lock lock(mutex_);
            if (device_ != device) drawer_.reset();
            device_ = device;
        }
        return use(drawer_);
    }
    // By the one who has that device for itself: nobody uses what is on it.
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
