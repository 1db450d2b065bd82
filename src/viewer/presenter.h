// Brings pictures to the window.
#pragma once

#include <memory>
#include <optional>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/gpu/swapchain.h"

namespace macula::viewer {

// Owns the swapchain of one surface and a copy of the picture shown last, so that a window that was covered
// can be filled again at once while the next picture is still being traced. Used by the render thread only.
class Presenter {
  public:
    // Errors: those of Swapchain::create.
    static Result<Presenter> create(const std::shared_ptr<gpu::Device>& device, VkSurfaceKHR surface,
                                    VkExtent2D extent);

    Result<void> resize(VkExtent2D extent);

    // Keeps a copy of `picture`, scales it over the window and shows it. Returns whether the window could be
    // drawn to: not while it is hidden.
    Result<bool> show(const gpu::Image& picture);
    // The same picture once more; false when there is none yet.
    Result<bool> showAgain();
    // From now on there is none.
    void forget() { keptIsValid_ = false; }
    // Fills the window with one colour, display-encoded RGBA.
    Result<bool> showColour(const VkClearColorValue& colour);

    // Waits for the device and lets go of the surface. Nothing can be shown afterwards.
    static Result<void> release(std::optional<Presenter> presenter);

  private:
    Presenter(std::shared_ptr<gpu::Device> device, gpu::Swapchain swapchain, VkExtent2D wanted);
    Result<void> keep(const gpu::Image& picture);

    std::shared_ptr<gpu::Device> device_;
    gpu::Swapchain swapchain_;
    VkExtent2D wanted_;
    std::optional<gpu::Image> kept_;
    bool keptIsValid_ = false;
};

}  // namespace macula::viewer
