// The resources that a dispatch binds to a shader.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstddef>
#include <span>
#include <string>

#include "pipeline/gpu/resources.h"

namespace macula::gpu {

// A resource for one binding. The shader decides which kind of descriptor it becomes.
class Binding {
  public:
    Binding(const Buffer& buffer);                         // buffer (std430, scalar) or uniform block
    Binding(const TexelBuffer& texels);                    // samplerBuffer or imageBuffer
    Binding(const TexelBuffer& texels, std::size_t view);  // the same, of one view
    Binding(const Image& image);                           // image2D, image3D, texture2D
    Binding(const Image& image, const Sampler& sampler);   // sampler2D, sampler3D

  private:
    friend class Kernel;
    friend class Recorder;

    enum class Kind { buffer, texelBuffer, image, sampledImage };
    bool fits(VkDescriptorType type) const;

    Kind kind_;
    const std::string* label_;
    VkDescriptorBufferInfo buffer_{};
    VkDescriptorImageInfo image_{};
    VkBufferView view_ = VK_NULL_HANDLE;
    VkFlags usage_ = 0;
    std::span<std::byte> mapped_;  // of a buffer, or of a texel buffer from this view on
};

}  // namespace macula::gpu
