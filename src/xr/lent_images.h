// An OpenXR swapchain: images that the headset lends, one at a time, and shows after they are returned.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/recorder.h"
#include "xr/session.h"

namespace macula::xr {

// Must not outlive its session. Used by one thread at a time, the one that uses the device.
class LentImages {
  public:
    struct Kind {
        std::int64_t format = 0;  // a VkFormat
        XrSwapchainUsageFlags usage = 0;
        VkImageLayout layout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;  // the layout of lent images
    };
    // R8G8B8A8_SRGB: our pictures are encoded already, and are copied bit by bit.
    static const Kind kColours;

    // Nothing if the runtime does not support this many layers of this kind.
    static Result<std::optional<LentImages>> create(const Session& session, const glm::ivec2& sizePx,
                                                    std::uint32_t layers, const Kind& kind);

    LentImages(LentImages&& other) noexcept;
    LentImages& operator=(LentImages&&) = delete;
    ~LentImages();

    // Waits until the headset lends an image. Does nothing if one is lent already.
    Result<void> acquire();
    // Returns the image to the headset, which shows it next, with all writes submitted until now. Does
    // nothing if none is lent.
    Result<void> release();
    // A layer of the lent image. Call it between acquire() and release().
    gpu::LentLayer layer(std::uint32_t number) const;
    // The upper left part of that size.
    XrSwapchainSubImage part(std::uint32_t layer, const glm::ivec2& partPx) const;

  private:
    LentImages(const Session& session, VkImageLayout layout)
        : runtime_(session.sharedRuntime()), device_(session.device()), layout_(layout) {}
    Result<void> findImages();

    std::shared_ptr<Runtime> runtime_;
    std::shared_ptr<gpu::Device> device_;
    VkImageLayout layout_;
    XrSwapchain handle_ = XR_NULL_HANDLE;
    std::vector<VkImage> images_;
    std::optional<std::uint32_t> lent_;  // index into images_
};

// The images of two views: two layers of one swapchain or, if the runtime does not support layers, two
// swapchains. Must not outlive its session. Used by one thread at a time, the one that uses the device.
class SwapchainPair {
  public:
    static constexpr std::size_t kViews = 2;

    // For pictures of at most that size; nothing if the runtime does not support the format.
    static Result<std::optional<SwapchainPair>> create(const Session& session, const glm::ivec2& sizePx,
                                                       const LentImages::Kind& kind);

    // Acquires an image for each view, which may wait until the headset has shown another. Does nothing for
    // images that are lent already.
    Result<void> acquire();
    // Returns them to the headset, which shows them next, with all writes submitted until now.
    Result<void> release();
    // The lent image of a view. Call it between acquire() and release().
    gpu::LentLayer image(std::size_t view) const { return chainOf(view).layer(layerOf(view)); }
    // The upper left part of that size.
    XrSwapchainSubImage part(std::size_t view, const glm::ivec2& partPx) const {
        return chainOf(view).part(layerOf(view), partPx);
    }

    const glm::ivec2& sizePx() const { return sizePx_; }
    std::size_t count() const { return chains_.size(); }
    const std::shared_ptr<gpu::Device>& device() const { return device_; }

  private:
    SwapchainPair(std::shared_ptr<gpu::Device> device, const glm::ivec2& sizePx)
        : device_(std::move(device)), sizePx_(sizePx) {}
    const LentImages& chainOf(std::size_t view) const { return chains_[chains_.size() == 1 ? 0 : view]; }
    std::uint32_t layerOf(std::size_t view) const {
        return chains_.size() == 1 ? static_cast<std::uint32_t>(view) : 0;
    }

    std::shared_ptr<gpu::Device> device_;
    glm::ivec2 sizePx_{0};
    std::vector<LentImages> chains_;  // one, or one for each view
};

}  // namespace macula::xr
