// The picture of a renderer that belongs to no window: kept on the device until its host fetches it.
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

namespace macula::app {

// RGBA, row 0 on top, scaled to the size that the host wants by repeating pixels: pictures that follow a hand
// may be smaller. Used by the thread of the renderer.
class HostPicture {
  public:
    bool isThere() const { return kept_.has_value(); }
    // How often one was shown.
    std::uint64_t count() const { return count_; }

    // Waits. False, and nothing is written, when there is none. The rows are of the host, `rowBytes` apart.
    Result<bool> writeTo(std::uint8_t* rgba, std::size_t rowBytes, const glm::ivec2& sizePx) const;
    // Of the same size, on the same device; it is there when this returns.
    Result<bool> copyTo(const LentPicture& target, const glm::ivec2& sizePx) const;
    // Copies the picture to an image of another device of the same card, scaled to the image's size. It is
    // there when this returns, or, where the target has a semaphore to signal, when that is signalled. Fails
    // as SharedImage::import. The import is kept for the next time, while `target` lives and the device is
    // the same.
    Result<bool> shareTo(const std::shared_ptr<const gpu::SharedMemory>& target);

    // By the screen.
    Result<void> keep(const std::shared_ptr<gpu::Device>& device, const gpu::Image& picture);
    void forget() { kept_.reset(); }
    void leaveDevice();  // nothing stays on it

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

// Where a renderer shows what `picture` keeps.
std::shared_ptr<const ScreenPlace> placeOf(std::shared_ptr<HostPicture> picture);

}  // namespace macula::app
