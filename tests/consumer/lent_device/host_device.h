/* The Vulkan of a program that is not Macula: a device, a queue, and an image whose pixels it can read. */
#ifndef HOST_DEVICE_H
#define HOST_DEVICE_H

#include <stdint.h>
#include <vulkan/vulkan.h>

#ifdef __cplusplus
extern "C" {
#endif

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
    int has_semaphores; /* it can share them: host_open_on */
    int is_shared;      /* the image, with another device, to which it belongs between two reads */
};

/* The lowest memory type that is allowed and has what is wanted; UINT32_MAX when there is none. */
uint32_t host_memory_type(const struct host_device* host, uint32_t allowed, VkMemoryPropertyFlags wanted);

/* As host_open, on the card of these UUIDs, ready to share memory, and without an image. */
int host_open_on(struct host_device* host, uint32_t width, uint32_t height, const uint8_t device_uuid[16],
                 const uint8_t driver_uuid[16], const char** what);

/* The image, to VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, from one queue family to another. */
void host_pass(struct host_device* host, VkCommandBuffer commands, VkImageLayout before, uint32_t from,
               uint32_t to);

/* Runs what `record` puts into a command buffer, and waits for it. 0 when that failed. */
typedef void (*host_commands)(struct host_device* host, VkCommandBuffer commands);
int host_run(struct host_device* host, host_commands record);

/* 0 when something is missing; `what` says what. */
int host_open(struct host_device* host, uint32_t width, uint32_t height, const char** what);
/* Of an image in VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, tightly packed: null when it failed. Until the next
 * call. */
const uint8_t* host_pixels(struct host_device* host);
void host_unmap(struct host_device* host);
void host_close(struct host_device* host);

#ifdef __cplusplus
}
#endif

#endif
