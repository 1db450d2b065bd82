// The picture of a renderer without a window: it stays on the device until its host fetches it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "live/frame/screen.h"
#include "live/hosted/lent_handles.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/gpu/shared_image.h"

namespace macula::live {

// RGBA, row 0 on top. Pictures of a moving view may be smaller than the size that the host wants, and are
// scaled by repeating pixels. Used by the renderer's thread.
class HostPicture {
  public:
    bool isThere() const { return kept_.has_value(); }
    // How many times the renderer showed a picture.
    std::uint64_t count() const { return count_; }

    // Waits for the device. False, with nothing written, if there is no picture. Rows are `rowBytes` apart.
    Result<bool> writeTo(std::uint8_t* rgba, std::size_t rowBytes, const glm::ivec2& sizePx) const;
    // Copies the picture to an image of `sizePx` on the same device; complete when this returns.
    Result<bool> copyTo(const LentPicture& target, const glm::ivec2& sizePx) const;
    // Copies the picture to an image of another device on the same card, scaled to the image's size. Complete
    // when this returns, or, if the target has a semaphore to signal, when that is signalled. Fails as
    // SharedImage::import. Keeps the import for the next call, while `target` lives and the device is the
    // same.
    Result<bool> shareTo(const std::shared_ptr<const gpu::SharedMemory>& target);

    // Called by the screen.
    Result<void> keep(const std::shared_ptr<gpu::Device>& device, const gpu::Image& picture);
    void forget() { kept_.reset(); }
    void leaveDevice();  // drops everything that is on the device

  private:
    struct Import {
        std::weak_ptr<const gpu::SharedMemory> of;
        gpu::SharedImage image;
    };

    Result<void> send(const gpu::LentLayer& target, const glm::ivec2& sizePx,
                      const gpu::SubmitOptions& semaphores) const;
    Result<const gpu::SharedImage*> importOf(const std::shared_ptr<const gpu::SharedMemory>& target);

    std::optional<gpu::Image> kept_;
    std::vector<Import> imports_;
    std::uint64_t count_ = 0;
};

// The place for FrameInput whose pictures `picture` keeps.
std::shared_ptr<const ScreenPlace> placeOf(std::shared_ptr<HostPicture> picture);

}  // namespace macula::live
