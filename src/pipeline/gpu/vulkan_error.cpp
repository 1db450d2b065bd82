#include "pipeline/gpu/vulkan_error.h"

namespace macula::gpu {

std::string_view vkResultName(VkResult result) {
    switch (result) {
        case VK_SUCCESS:
            return "VK_SUCCESS";
        case VK_NOT_READY:
            return "VK_NOT_READY";
        case VK_TIMEOUT:
            return "VK_TIMEOUT";
        case VK_INCOMPLETE:
            return "VK_INCOMPLETE";
        case VK_SUBOPTIMAL_KHR:
            return "VK_SUBOPTIMAL_KHR";
        case VK_ERROR_OUT_OF_HOST_MEMORY:
            return "VK_ERROR_OUT_OF_HOST_MEMORY";
        case VK_ERROR_OUT_OF_DEVICE_MEMORY:
            return "VK_ERROR_OUT_OF_DEVICE_MEMORY";
        case VK_ERROR_OUT_OF_POOL_MEMORY:
            return "VK_ERROR_OUT_OF_POOL_MEMORY";
        case VK_ERROR_INITIALIZATION_FAILED:
            return "VK_ERROR_INITIALIZATION_FAILED";
        case VK_ERROR_DEVICE_LOST:
            return "VK_ERROR_DEVICE_LOST";
        case VK_ERROR_MEMORY_MAP_FAILED:
            return "VK_ERROR_MEMORY_MAP_FAILED";
        case VK_ERROR_LAYER_NOT_PRESENT:
            return "VK_ERROR_LAYER_NOT_PRESENT";
        case VK_ERROR_EXTENSION_NOT_PRESENT:
            return "VK_ERROR_EXTENSION_NOT_PRESENT";
        case VK_ERROR_FEATURE_NOT_PRESENT:
            return "VK_ERROR_FEATURE_NOT_PRESENT";
        case VK_ERROR_INCOMPATIBLE_DRIVER:
            return "VK_ERROR_INCOMPATIBLE_DRIVER";
        case VK_ERROR_TOO_MANY_OBJECTS:
            return "VK_ERROR_TOO_MANY_OBJECTS";
        case VK_ERROR_FORMAT_NOT_SUPPORTED:
            return "VK_ERROR_FORMAT_NOT_SUPPORTED";
        case VK_ERROR_SURFACE_LOST_KHR:
            return "VK_ERROR_SURFACE_LOST_KHR";
        case VK_ERROR_NATIVE_WINDOW_IN_USE_KHR:
            return "VK_ERROR_NATIVE_WINDOW_IN_USE_KHR";
        case VK_ERROR_OUT_OF_DATE_KHR:
            return "VK_ERROR_OUT_OF_DATE_KHR";
        default:
            return "a VkResult without a name here";
    }
}

Error vulkanError(VkResult result, const Text& doing) {
    switch (result) {
        case VK_ERROR_OUT_OF_HOST_MEMORY:
            return {ErrorCode::outOfMemory, Text("Could not {}: the computer's memory is full.", doing), "",
                    Text("Close other programs, or open a smaller series.")};
        case VK_ERROR_OUT_OF_DEVICE_MEMORY:
            return {ErrorCode::outOfMemory, Text("Could not {}: the graphics memory is full.", doing), "",
                    Text("Close other programs that draw in 3D, open a smaller series, or choose another "
                         "device with "
                         "MACULA_DEVICE.")};
        case VK_ERROR_DEVICE_LOST:
            return {ErrorCode::deviceLost,
                    Text("Could not {}: the graphics device stopped responding and was reset.", doing), "",
                    Text("Try again. If this comes back, update the graphics driver, or choose another "
                         "device with "
                         "MACULA_DEVICE.")};
        case VK_ERROR_SURFACE_LOST_KHR:
            return {ErrorCode::deviceNotUsable,
                    Text("Could not {}: the window system took the window away.", doing), "",
                    Text("Open the window again.")};
        default:
            return {ErrorCode::deviceNotUsable,
                    Text("Could not {}: the graphics driver reports {}.", doing, vkResultName(result)), "",
                    Text("Update the graphics driver, or choose another device with MACULA_DEVICE.")};
    }
}

Text bytesText(std::uint64_t bytes) {
    constexpr std::string_view kUnits[] = {"KiB", "MiB", "GiB", "TiB", "PiB", "EiB"};
    if (bytes < 1024) return Text("{} bytes", bytes);
    double value = static_cast<double>(bytes) / 1024.0;
    std::size_t unit = 0;
    for (; value >= 1024.0 && unit + 1 < std::size(kUnits); ++unit) value /= 1024.0;
    return Text("{:.1f} {}", value, kUnits[unit]);
}

}  // namespace macula::gpu
