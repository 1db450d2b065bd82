/* Images of the host into which frames are delivered. */
#ifndef MACULA_SHARED_IMAGE_H
#define MACULA_SHARED_IMAGE_H

#include <stdint.h>

#include "status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* An image on the lent device: a VkImage of R8G8B8A8 (UNORM, or SRGB: bits are copied), of the size of the
 * frame, with VK_IMAGE_USAGE_TRANSFER_DST_BIT, which nobody else uses meanwhile. */
typedef struct macula_lent_image {
    uint32_t size;
    int32_t layout;    /* VkImageLayout that it is left in, 0: general; what it held before is lost */
    uint64_t image;    /* VkImage */
    uint32_t layer;    /* of the image */
    uint32_t reserved; /* 0 */
} macula_lent_image;

/* Your image on another device object than Macula's, but on the same card: of your own VkDevice, which is not
 * lent, or of OpenGL (GL_EXT_memory_object_fd), with memory that a VkDevice allocated. Describe it exactly as
 * it was made, because a driver need not notice mistakes. For Linux only: Windows handles are not accepted.
 *
 * It is a VkImage with VkExternalMemoryImageCreateInfo of VK_EXTERNAL_MEMORY_HANDLE_TYPE_OPAQUE_FD_BIT, of
 * two dimensions, one level, one layer and one sample, VK_SHARING_MODE_EXCLUSIVE. Macula writes all of it
 * without acquiring it: what it held is lost. Macula releases it to VK_QUEUE_FAMILY_EXTERNAL in `layout`;
 * acquire it from there with `layout` as the old and the new layout.
 *
 * Semaphores are binary VkSemaphores of VK_EXTERNAL_SEMAPHORE_HANDLE_TYPE_OPAQUE_FD_BIT, and may be missing.
 * Each delivered frame waits for `wait_fd` once, before it writes, and signals `signal_fd` once, when it has
 * written; a call that fails does neither, unless the device was lost. Submit the signal of `wait_fd` before
 * the call, and your wait for `signal_fd` before the next call: Macula waits for ever for a signal that never
 * comes. After a call that failed, the signal of `wait_fd` is still there for the next. If Macula's device is
 * lost, even after a call, `signal_fd` may never be signalled: wait for your own submission with a time
 * limit, and once that has passed share the image again, with new semaphores. Not every device can share
 * semaphores: lavapipe cannot. */
typedef struct macula_shared_memory {
    uint32_t size;
    int32_t memory_fd;       /* of vkGetMemoryFdKHR, above 0 */
    uint8_t device_uuid[16]; /* of the card: macula_device_identify gives that of Macula's */
    uint8_t driver_uuid[16];
    uint64_t bytes;       /* VkMemoryAllocateInfo: allocationSize */
    uint64_t offset;      /* bytes, where the image is bound */
    uint32_t memory_type; /* VkMemoryAllocateInfo: memoryTypeIndex */
    int32_t is_dedicated; /* not 0: with VkMemoryDedicatedAllocateInfo of the image */
    int32_t width;        /* pixels, 1 to 16384 */
    int32_t height;
    int32_t format;    /* VkFormat: R8G8B8A8, UNORM or SRGB: bits are copied, encoded for display */
    int32_t tiling;    /* VkImageTiling: optimal or linear */
    uint32_t usage;    /* VkImageUsageFlags, with TRANSFER_DST: for transfers, sampling, storage, colour */
    uint32_t flags;    /* VkImageCreateFlags: mutable format, extended usage, alias, or 0 */
    int32_t layout;    /* VkImageLayout that it is left in, 0: general */
    int32_t wait_fd;   /* of vkGetSemaphoreFdKHR, above 0; otherwise Macula may write at once */
    int32_t signal_fd; /* the same; otherwise the picture is complete when the call returns */
    uint32_t reserved; /* 0 */
} macula_shared_memory;

typedef struct macula_shared_image macula_shared_image;
/* Macula duplicates the file descriptors: yours stay open, and you may close them at once. Only the first
 * frame shows which card draws: it fails if that is another one (MACULA_USAGE), or cannot share images or
 * semaphores (MACULA_DEVICE). A device that replaces a lost one gets the image again on its own; for
 * semaphores see above. */
MACULA_API macula_status macula_shared_image_create(const macula_shared_memory* memory,
                                                    macula_shared_image** image);
/* A live picture drops its import with its next frame to another shared image, or when it is closed. */
MACULA_API void macula_shared_image_close(macula_shared_image* image);

#ifdef __cplusplus
}
#endif

#endif
