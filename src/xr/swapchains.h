// The images that the headset shows: one for each eye, as two layers of one swapchain or, where the runtime
// does not take these, as two swapchains.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/resources.h"
#include "xr/eyes.h"
#include "xr/session.h"

namespace macula::xr {

// Must not outlive its session. Used by one thread at a time, the one that uses the device.
class Swapchains {
  public:
    // For pictures of at most that size. R8G8B8A8_SRGB: our pictures are encoded already, and are copied bit
    // by bit. deviceNotUsable when the runtime does not take that.
    static Result<Swapchains> create(const Session& session, const glm::ivec2& sizePx);

    Swapchains(Swapchains&& other) noexcept;
    Swapchains& operator=(Swapchains&&) = delete;
    ~Swapchains();

    // Copies the part of each eye's picture, and says of which views the layer is made. Waits for the
    // runtime, and for no drawing.
    Result<std::vector<XrCompositionLayerProjectionView>> show(const EyePictures& eyes,
                                                               std::span<const gpu::Image* const> pictures);

    const glm::ivec2& sizePx() const { return sizePx_; }
    std::size_t count() const { return chains_.size(); }

  private:
    struct Chain {
        XrSwapchain handle = XR_NULL_HANDLE;
        std::vector<VkImage> images;
    };

    Swapchains(std::shared_ptr<Runtime> runtime, std::shared_ptr<gpu::Device> device,
               const glm::ivec2& sizePx)
        : runtime_(std::move(runtime)), device_(std::move(device)), sizePx_(sizePx) {}
    Result<bool> add(const Session& session, std::uint32_t layers);  // false: the runtime takes no layers
    Result<VkImage> acquire(const Chain& chain);
    Result<void> copy(const EyePictures& eyes, std::span<const gpu::Image* const> pictures,
                      std::span<const VkImage> images);
    std::size_t chainOf(std::size_t eye) const { return chains_.size() == 1 ? 0 : eye; }
    std::uint32_t layerOf(std::size_t eye) const {
        return chains_.size() == 1 ? static_cast<std::uint32_t>(eye) : 0;
    }

    std::shared_ptr<Runtime> runtime_;
    std::shared_ptr<gpu::Device> device_;
    glm::ivec2 sizePx_{0};
    std::vector<Chain> chains_;
};

}  // namespace macula::xr
