// What a dispatch gives to a shader.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstddef>
#include <string>

#include "pipeline/gpu/resources.h"

namespace macula::gpu {

// A resource for one binding. Which kind of descriptor it becomes is for the shader to say.
class Binding {
  public:
    Binding(const Buffer& buffer);                         // buffer (std430, scalar) or uniform block
    Binding(const TexelBuffer& texels);                    // samplerBuffer or imageBuffer
    Binding(const TexelBuffer& texels, std::size_t view);  // likewise, one of its views
    Binding(const Image& image);                           // image2D, image3D, texture2D
    Binding(const Image& image, const Sampler& sampler);   // sampler2D, sampler3D

  private:
    friend class Recorder;

    enum class Kind { buffer, texelBuffer, image, sampledImage };
    bool fits(VkDescriptorType type) const;

    Kind kind_;
    const std::string* label_;
    VkDescriptorBufferInfo buffer_{};
    VkDescriptorImageInfo image_{};
    VkBufferView view_ = VK_NULL_HANDLE;
    VkFlags usage_ = 0;
};

}  // namespace macula::gpu
