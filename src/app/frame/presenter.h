// Brings pictures to the window.
#pragma once

#include <memory>
#include <optional>

#include "app/frame/picture_text.h"
#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/gpu/swapchain.h"

namespace macula::app {

// Owns the swapchain of one surface and a copy of the picture shown last, so that a window that was covered
// can be filled again at once while the next picture is still being traced. Used by the render thread only.
class Presenter {
  public:
    // Errors: those of Swapchain::create.
    static Result<Presenter> create(const std::shared_ptr<gpu::Device>& device, VkSurfaceKHR surface,
                                    VkExtent2D extent);

    Result<void> resize(VkExtent2D extent);

    // What is written over pictures from the next time on that one is shown, also again; never over a colour.
    // Null: nothing.
    void setText(std::shared_ptr<const PictureText> text);
    const std::shared_ptr<const PictureText>& text() const { return text_; }

    // Keeps a copy of `picture`, scales it over the window and shows it. Returns whether it is there: not
    // while the window is hidden, nor when the window system gives out no image in time (see owes).
    Result<bool> show(const gpu::Image& picture);
    // The same picture once more; false when there is none yet.
    Result<bool> showAgain();
    // What was to be shown last is not there yet, though the window is not hidden: showAgain, until it is.
    bool owes() const { return owes_; }
    // Drops the picture: from now on there is none to show again.
    void forget() { keptIsValid_ = owes_ = false; }
    // Fills the window with one colour, display-encoded RGBA.
    Result<bool> showColour(const VkClearColorValue& colour);

    // Waits for the device and lets go of the surface. Nothing can be shown afterwards.
    static Result<void> release(std::optional<Presenter> presenter);

  private:
    Presenter(std::shared_ptr<gpu::Device> device, gpu::Swapchain swapchain, VkExtent2D wanted);
    Result<void> keep(const gpu::Image& picture);
    Result<gpu::BlitOverlay> overlay();

    std::shared_ptr<gpu::Device> device_;
    gpu::Swapchain swapchain_;
    VkExtent2D wanted_;
    std::optional<gpu::Image> kept_;
    bool keptIsValid_ = false;
    bool owes_ = false;
    bool isColour_ = false;  // what is kept is a colour
    std::shared_ptr<const PictureText> text_;
    std::optional<gpu::Image> textImage_;  // text_ as an image; made when it is first shown
};

}  // namespace macula::app
