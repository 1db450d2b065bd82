// Where a renderer's pictures go: a window, a host program or a recording.
#pragma once

#include <vulkan/vulkan_core.h>

#include <memory>
#include <vector>

#include "base/result.h"
#include "live/frame/picture_text.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/resources.h"

namespace macula::live {

// Used by the render thread only.
class Screen {
  public:
    virtual ~Screen() = default;

    virtual Result<void> resize(VkExtent2D extent) = 0;

    // Sets the text drawn over pictures, from the next show() or showAgain() on; never drawn over a colour.
    // Null: none.
    virtual void setText(std::shared_ptr<const PictureText> text) = 0;
    virtual const std::shared_ptr<const PictureText>& text() const = 0;
    // Sets the marks of one picture, whose camera they fit: call before show() or showAgain().
    virtual void setMarks(std::shared_ptr<const PictureText> marks) = 0;
    virtual const std::shared_ptr<const PictureText>& marks() const = 0;

    // Shows `picture`, and keeps a copy if it may have to be shown again. Returns whether it is visible:
    // false while the window is hidden, or if the window system has no image in time (see owes).
    virtual Result<bool> show(const gpu::Image& picture) = 0;
    // Shows the same picture again; false when there is none yet.
    virtual Result<bool> showAgain() = 0;
    // The last picture is not visible yet, though the window is not hidden: call showAgain() until it is.
    virtual bool owes() const = 0;
    // Drops the kept picture: showAgain() then has none.
    virtual void forget() = 0;
    // Fills the screen with one colour, display-encoded RGBA.
    virtual Result<bool> showColour(const VkClearColorValue& colour) = 0;
};

// What a screen is opened on, such as a surface. Immutable.
class ScreenPlace {
  public:
    virtual ~ScreenPlace() = default;

    virtual std::vector<const char*> deviceExtensions() const = 0;
    virtual Result<std::unique_ptr<Screen>> open(const std::shared_ptr<gpu::Device>& device,
                                                 VkExtent2D extent) const = 0;
};

}  // namespace macula::live
