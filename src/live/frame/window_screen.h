// Presents pictures in a window.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "live/frame/screen.h"
#include "pipeline/gpu/swapchain.h"

namespace macula::live {

// A surface of the window system, owned by the window.
class WindowPlace final : public ScreenPlace {
  public:
    explicit WindowPlace(VkSurfaceKHR surface) : surface_(surface) {}

    std::vector<const char*> deviceExtensions() const override { return {VK_KHR_SWAPCHAIN_EXTENSION_NAME}; }
    // Errors: those of Swapchain::create.
    Result<std::unique_ptr<Screen>> open(const std::shared_ptr<gpu::Device>& device,
                                         VkExtent2D extent) const override;

  private:
    VkSurfaceKHR surface_;
};

// Owns the swapchain of one surface and a copy of the last picture, so that an uncovered window can be filled
// at once while the next picture is still being traced.
class WindowScreen final : public Screen {
  public:
    WindowScreen(std::shared_ptr<gpu::Device> device, gpu::Swapchain swapchain, VkExtent2D wanted);

    Result<void> resize(VkExtent2D extent) override;
    void setText(std::shared_ptr<const PictureText> text) override;
    const std::shared_ptr<const PictureText>& text() const override { return text_.text; }
    void setMarks(std::shared_ptr<const PictureText> marks) override;
    const std::shared_ptr<const PictureText>& marks() const override { return marks_.text; }
    // Scales the picture to the window.
    Result<bool> show(const gpu::Image& picture) override;
    Result<bool> showAgain() override;
    bool owes() const override { return owes_; }
    void forget() override { keptIsValid_ = owes_ = false; }
    Result<bool> showColour(const VkClearColorValue& colour) override;

  private:
    Result<void> keep(const gpu::Image& picture);
    struct Overlay {
        std::shared_ptr<const PictureText> text;
        std::optional<gpu::Image> image;  // of the text; created when first shown
    };
    Result<void> prepare(Overlay& overlay);
    std::vector<gpu::BlitOverlay> overlaysFor(VkExtent2D target) const;

    std::shared_ptr<gpu::Device> device_;
    gpu::Swapchain swapchain_;
    VkExtent2D wanted_;
    std::optional<gpu::Image> kept_;
    bool keptIsValid_ = false;
    bool owes_ = false;
    bool isColour_ = false;  // the kept picture is a single colour
    Overlay text_;
    Overlay marks_;
};

}  // namespace macula::live
