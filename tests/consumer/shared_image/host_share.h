/* What a host shares with another device of its card: the memory of its image, and semaphores. */
#ifndef HOST_SHARE_H
#define HOST_SHARE_H

#include "host_device.h"

#ifdef __cplusplus
extern "C" {
#endif

struct host_share {
    /* How the image is to be made. */
    VkFormat format;
    VkImageTiling tiling;
    VkImageUsageFlags usage;
    int is_dedicated;    /* comes back set where it has to be */
    VkDeviceSize offset; /* in its memory; comes back as it is possible, and 0 where that is dedicated */
    /* How it was made. */
    VkDeviceSize bytes;
    uint32_t memory_type;
};

/* Whether the device gives away the memory of an image like this. */
int host_can_share(const struct host_device* host, const struct host_share* share);
/* Makes the host's image so, and its memory; 0 when that failed. Of a host that host_open_on has opened. */
int host_share_image(struct host_device* host, struct host_share* share);
/* Each call makes another one, to be closed; below 0 when that failed. */
int host_memory_fd(struct host_device* host);

/* Binary ones that can be shared; 0 when that failed. */
int host_make_semaphore(struct host_device* host, VkSemaphore* semaphore);
int host_semaphore_fd(struct host_device* host, VkSemaphore semaphore);
/* Waits for one in the queue, and signals another; either may be null. Returns at once; 0 when that failed.
 */
int host_submit(struct host_device* host, VkSemaphore wait, VkSemaphore signal);

#ifdef __cplusplus
}
#endif

#endif
