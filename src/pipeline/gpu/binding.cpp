#include "pipeline/gpu/binding.h"

namespace macula::gpu {

Binding::Binding(const Buffer& buffer)
    : kind_(Kind::buffer),
      label_(&buffer.label()),
      buffer_{buffer.handle(), 0, VK_WHOLE_SIZE},
      usage_(buffer.usage()) {}

Binding::Binding(const TexelBuffer& texels) : Binding(texels, 0) {}

Binding::Binding(const TexelBuffer& texels, std::size_t view)
    : kind_(Kind::texelBuffer),
      label_(&texels.buffer().label()),
      view_(texels.view(view)),
      usage_(texels.buffer().usage()) {}

Binding::Binding(const Image& image)
    : kind_(Kind::image),
      label_(&image.label()),
      image_{VK_NULL_HANDLE, image.view(), VK_IMAGE_LAYOUT_GENERAL},
      usage_(image.usage()) {}

Binding::Binding(const Image& image, const Sampler& sampler)
    : kind_(Kind::sampledImage),
      label_(&image.label()),
      image_{sampler.handle(), image.view(), VK_IMAGE_LAYOUT_GENERAL},
      usage_(image.usage()) {}

bool Binding::fits(VkDescriptorType type) const {
    switch (type) {
        case VK_DESCRIPTOR_TYPE_STORAGE_BUFFER:
            return kind_ == Kind::buffer && (usage_ & VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
        case VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER:
            return kind_ == Kind::buffer && (usage_ & VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
        case VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER:
            return kind_ == Kind::texelBuffer && (usage_ & VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT);
        case VK_DESCRIPTOR_TYPE_STORAGE_TEXEL_BUFFER:
            return kind_ == Kind::texelBuffer && (usage_ & VK_BUFFER_USAGE_STORAGE_TEXEL_BUFFER_BIT);
        case VK_DESCRIPTOR_TYPE_STORAGE_IMAGE:
            return kind_ == Kind::image && (usage_ & VK_IMAGE_USAGE_STORAGE_BIT);
        case VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE:
            return kind_ == Kind::image && (usage_ & VK_IMAGE_USAGE_SAMPLED_BIT);
        case VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER:
            return kind_ == Kind::sampledImage && (usage_ & VK_IMAGE_USAGE_SAMPLED_BIT);
        default:
            return false;
    }
}

}  // namespace macula::gpu
