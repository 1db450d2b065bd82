// Where a renderer's pictures go: into a window, or to whoever records them.
#pragma once

#include <vulkan/vulkan_core.h>

#include <memory>
#include <vector>

#include "base/result.h"
#include "live/frame/picture_text.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/resources.h"

namespace macula::app {

// Used by the render thread only.
class Screen {
  public:
    virtual ~Screen() = default;

    virtual Result<void> resize(VkExtent2D extent) = 0;

    // What is written over pictures from the next time on that one is shown, also again; never over a colour.
    // Null: nothing.
    virtual void setText(std::shared_ptr<const PictureText> text) = 0;
    virtual const std::shared_ptr<const PictureText>& text() const = 0;
    // Likewise what is of one picture only, of its camera: set before that is shown, or shown again.
    virtual void setMarks(std::shared_ptr<const PictureText> marks) = 0;
    virtual const std::shared_ptr<const PictureText>& marks() const = 0;

    // Shows `picture`, and keeps a copy where it may have to be shown again. Returns whether it is there: not
    // while the window is hidden, nor when the window system gives out no image in time (see owes).
    virtual Result<bool> show(const gpu::Image& picture) = 0;
    // The same picture once more; false when there is none yet.
    virtual Result<bool> showAgain() = 0;
    // What was to be shown last is not there yet, though the window is not hidden: showAgain, until it is.
    virtual bool owes() const = 0;
    // Drops the picture: from now on there is none to show again.
    virtual void forget() = 0;
    // One colour over all, display-encoded RGBA.
    virtual Result<bool> showColour(const VkClearColorValue& colour) = 0;
};

// What a screen is opened on. Owned by whoever shows pictures; immutable.
class ScreenPlace {
  public:
    virtual ~ScreenPlace() = default;

    virtual std::vector<const char*> deviceExtensions() const = 0;
    virtual Result<std::unique_ptr<Screen>> open(const std::shared_ptr<gpu::Device>& device,
                                                 VkExtent2D extent) const = 0;
};

}  // namespace macula::app
