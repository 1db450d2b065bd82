// Whether tests run under the validation layer: where it is installed. ./check installs it; a bare machine
// with a card runs the tests all the same, and says that it is without.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <cstdio>
#include <string_view>
#include <vector>

#include "pipeline/gpu/instance.h"

namespace macula::gpu {

inline Validation validationOfTests() {
    static const Validation there = [] {
        std::uint32_t count = 0;
        vkEnumerateInstanceLayerProperties(&count, nullptr);
        std::vector<VkLayerProperties> layers(count);
        vkEnumerateInstanceLayerProperties(&count, layers.data());
        for (const VkLayerProperties& layer : layers)
            if (std::string_view(layer.layerName) == "VK_LAYER_KHRONOS_validation") return Validation::on;
        std::fputs("NOT VALIDATED: the Vulkan validation layer is not installed.\n", stderr);
        return Validation::off;
    }();
    return there;
}

}  // namespace macula::gpu
