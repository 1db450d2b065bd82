/* The Vulkan of a program that is not Macula: a device, a queue, and an image whose pixels it can read. */
#ifndef HOST_DEVICE_H
#define HOST_DEVICE_H

#include <stdint.h>
#include <vulkan/vulkan.h>

struct host_device {
    VkInstance instance;
    VkPhysicalDevice physical;
    VkDevice device;
    VkQueue queue;
    uint32_t family;
    /* width * height, RGBA of 8 bits */
    VkImage image;
    VkDeviceMemory image_memory;
    VkBuffer pixels;
    VkDeviceMemory pixels_memory;
    uint32_t width;
    uint32_t height;
};

/* 0 when something is missing; `what` says what. */
int host_open(struct host_device* host, uint32_t width, uint32_t height, const char** what);
/* Of an image in VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, tightly packed: null when it failed. Until the next
 * call. */
const uint8_t* host_pixels(struct host_device* host);
void host_unmap(struct host_device* host);
void host_close(struct host_device* host);

#endif
