// The image of a SharedMemory on one of Macula's devices: the same texels as on the device that made it,
// without a copy between them (VK_KHR_external_memory_fd, VK_KHR_external_semaphore_fd).
//
//   MACULA_TRY(const auto image, gpu::SharedImage::import(device, memory));
//   recorder.copy(picture, part, image.layer());
//   recorder.submit(image.semaphores());
#pragma once

#include <vulkan/vulkan_core.h>

#include <memory>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/handle.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/shared_memory.h"

namespace macula::gpu {

// Move-only; may be dropped at any time as all resources may. The other device's image stays.
class SharedImage {
  public:
    // Fails with usage when the memory belongs to another card or driver, does not fit the image, or cannot
    // be imported; with deviceNotUsable when the device cannot import; with deviceLost.
    static Result<SharedImage> import(const std::shared_ptr<Device>& device, const SharedMemory& memory);

    const std::shared_ptr<Device>& device() const { return image_.device(); }
    // The target for Recorder::copy of a picture of the same size.
    LentLayer layer() const { return {image_.get(), 0, layout_, true}; }
    // For the submission that writes the image; each submission uses each semaphore once.
    SubmitOptions semaphores() const { return {wait_.get(), signal_.get()}; }
    // Whether a semaphore tells the image's owner when it is written.
    bool signals() const { return bool(signal_); }

  private:
    SharedImage() = default;

    VkImageLayout layout_ = VK_IMAGE_LAYOUT_GENERAL;
    Handle<VkDeviceMemory> memory_;
    Handle<VkImage> image_;  // dropped before its memory
    Handle<VkSemaphore> wait_;
    Handle<VkSemaphore> signal_;
};

}  // namespace macula::gpu
