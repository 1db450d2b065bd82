/* Images of the host that frames are delivered to. */
#ifndef MACULA_SHARED_IMAGE_H
#define MACULA_SHARED_IMAGE_H

#include <stdint.h>

#include "status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* An image on the device that is lent: VkImage of R8G8B8A8 (UNORM, or SRGB: bits are copied), of the size of
 * the frame, with VK_IMAGE_USAGE_TRANSFER_DST_BIT, not used by others meanwhile. */
typedef struct macula_lent_image {
    uint32_t size;
    int32_t layout;    /* VkImageLayout that it is left in, 0: general; what it held before is lost */
    uint64_t image;    /* VkImage */
    uint32_t layer;    /* of the image */
    uint32_t reserved; /* 0 */
} macula_lent_image;

/* An image of yours on another device object than Macula's, of the same card: of your own VkDevice, which is
 * not lent, or of OpenGL (GL_EXT_memory_object_fd), for which a VkDevice made the memory. Describe it just as
 * it was made; a driver need not notice what is wrong. For Linux: handles of Windows are not taken.
 *
 * It is a VkImage with VkExternalMemoryImageCreateInfo of VK_EXTERNAL_MEMORY_HANDLE_TYPE_OPAQUE_FD_BIT, of
 * two dimensions, one level, one layer and one sample, VK_SHARING_MODE_EXCLUSIVE. Macula writes the whole of
 * it without acquiring it: what it held is lost. It is left released to VK_QUEUE_FAMILY_EXTERNAL in `layout`;
 * acquire it from there with that as the old and the new layout.
 *
 * Semaphores are binary VkSemaphores of VK_EXTERNAL_SEMAPHORE_HANDLE_TYPE_OPAQUE_FD_BIT, and may be missing.
 * Each frame that is delivered waits for `wait_fd` once, before it writes, and signals `signal_fd` once, when
 * it has written; a call that fails does neither, unless the device was lost. Submit the signal that it waits
 * for before the call, and the wait for what it signals before the next: a signal that never comes is waited
 * for for ever. After a call that failed it is still there for the next. Where Macula's device is lost, also
 * after a call, what it was to signal may never be: wait for your own submission with a limit of time, and
 * once that has passed share the image anew, with new semaphores. Not every device can share them: lavapipe
 * cannot. */
typedef struct macula_shared_memory {
    uint32_t size;
    int32_t memory_fd;       /* of vkGetMemoryFdKHR, above 0 */
    uint8_t device_uuid[16]; /* of the card: macula_device_identify tells Macula's */
    uint8_t driver_uuid[16];
    uint64_t bytes;       /* VkMemoryAllocateInfo: allocationSize */
    uint64_t offset;      /* bytes, where the image is bound */
    uint32_t memory_type; /* VkMemoryAllocateInfo: memoryTypeIndex */
    int32_t is_dedicated; /* not 0: with VkMemoryDedicatedAllocateInfo of the image */
    int32_t width;        /* pixels, 1 to 16384 */
    int32_t height;
    int32_t format;    /* VkFormat: R8G8B8A8, UNORM or SRGB: bits are copied, encoded for display */
    int32_t tiling;    /* VkImageTiling: optimal or linear */
    uint32_t usage;    /* VkImageUsageFlags, with TRANSFER_DST: of transfers, sampling, storage, colour */
    uint32_t flags;    /* VkImageCreateFlags: mutable format, extended usage, alias, or 0 */
    int32_t layout;    /* VkImageLayout that it is left in, 0: general */
    int32_t wait_fd;   /* of vkGetSemaphoreFdKHR, above 0; else the image may be written to at once */
    int32_t signal_fd; /* the same; else the picture is there when the call returns */
    uint32_t reserved; /* 0 */
} macula_shared_memory;

typedef struct macula_shared_image macula_shared_image;
/* Macula duplicates the file descriptors: yours stay open, and are yours to close, at once if you like. Which
 * card draws shows with the first frame, and that fails where it is another one (MACULA_USAGE), or where it
 * cannot share images, or semaphores (MACULA_DEVICE). A device that was lost and replaced has the image again
 * by itself; of semaphores see above. */
MACULA_API macula_status macula_shared_image_create(const macula_shared_memory* memory,
                                                    macula_shared_image** image);
/* What a live picture has of it goes with its next frame to another shared image, or with its close. */
MACULA_API void macula_shared_image_close(macula_shared_image* image);

#ifdef __cplusplus
}
#endif

#endif
