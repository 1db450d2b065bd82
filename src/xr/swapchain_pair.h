// The images of two views that the headset lends: as two layers of one swapchain or, where the runtime does
// not take these, as two swapchains.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/recorder.h"
#include "xr/session.h"

namespace macula::xr {

// Must not outlive its session. Used by one thread at a time, the one that uses the device.
class SwapchainPair {
  public:
    static constexpr std::size_t kViews = 2;

    struct Kind {
        std::int64_t format = 0;  // a VkFormat
        XrSwapchainUsageFlags usage = 0;
        VkImageLayout layout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;  // in which images are lent
    };
    // For pictures of at most that size; nothing when the runtime does not take the format.
    static Result<std::optional<SwapchainPair>> create(const Session& session, const glm::ivec2& sizePx,
                                                       const Kind& kind);

    SwapchainPair(SwapchainPair&& other) noexcept;
    SwapchainPair& operator=(SwapchainPair&&) = delete;
    ~SwapchainPair();

    // An image for each view, which may take until the headset has shown another. Those that are lent already
    // stay.
    Result<void> acquire();
    // Gives them back, as they were written by what was submitted until now: they are shown next.
    Result<void> release();
    // Of a view, between the two.
    gpu::LentLayer image(std::size_t view) const;
    // The upper left part of that size.
    XrSwapchainSubImage part(std::size_t view, const glm::ivec2& partPx) const;

    const glm::ivec2& sizePx() const { return sizePx_; }
    std::size_t count() const { return chains_.size(); }
    const std::shared_ptr<gpu::Device>& device() const { return device_; }

  private:
    struct Chain {
        XrSwapchain handle = XR_NULL_HANDLE;
        std::vector<VkImage> images;
        std::optional<std::uint32_t> lent;  // the image
    };

    SwapchainPair(const Session& session, const glm::ivec2& sizePx, const Kind& kind)
        : runtime_(session.sharedRuntime()), device_(session.device()), sizePx_(sizePx), kind_(kind) {}
    Result<bool> add(const Session& session, std::uint32_t layers);  // false: the runtime takes no layers
    std::size_t chainOf(std::size_t view) const { return chains_.size() == 1 ? 0 : view; }
    std::uint32_t layerOf(std::size_t view) const {
        return chains_.size() == 1 ? static_cast<std::uint32_t>(view) : 0;
    }

    std::shared_ptr<Runtime> runtime_;
    std::shared_ptr<gpu::Device> device_;
    glm::ivec2 sizePx_{0};
    Kind kind_;
    std::vector<Chain> chains_;
};

}  // namespace macula::xr
