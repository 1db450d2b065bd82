/* Devices that draw: Macula's own, or lent by the host. */
#ifndef MACULA_DEVICE_H
#define MACULA_DEVICE_H

#include <stdint.h>

#include "status.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct macula_device macula_device;

/* Opens a device by its number or a part of its name; null: by MACULA_DEVICE in the environment, otherwise
 * the best one. Without a graphics card, Mesa's lavapipe draws on the CPU. */
MACULA_API macula_status macula_device_open(const char* preferred, macula_device** device);

/* Called before and after each use of a queue, by the thread that uses it. They must not call Macula, nor
 * throw. */
typedef void (*macula_queue_call)(void* user);

/* Your own device, used instead of one that Macula opens: Vulkan 1.3, with VK_KHR_push_descriptor and the
 * features timelineSemaphore, scalarBlockLayout, synchronization2 and maintenance4. Macula destroys nothing
 * of it; close what was opened with it before you destroy it. */
typedef struct macula_lent_device {
    uint32_t size;
    uint32_t queue_family; /* of the queue */
    void* instance;        /* VkInstance, made for Vulkan 1.3 */
    void* physical_device; /* VkPhysicalDevice */
    void* device;          /* VkDevice */
    void* queue;           /* VkQueue, with compute */
    /* Both null: do not use the queue while a call of Macula that uses this device runs, and lend the queue
     * only once at a time. */
    macula_queue_call lock_queue;
    macula_queue_call unlock_queue;
    void* user; /* for both */
} macula_lent_device;
/* Like macula_device_open, for a lent device. */
MACULA_API macula_status macula_device_lend(const macula_lent_device* lent, macula_device** device);

/* Identifies the card and the driver of a device to every program: VkPhysicalDeviceIDProperties, or
 * GL_DEVICE_UUID_EXT and GL_DRIVER_UUID_EXT. */
typedef struct macula_device_identity {
    uint32_t size;
    uint32_t reserved; /* 0 */
    uint8_t device_uuid[16];
    uint8_t driver_uuid[16];
} macula_device_identity;
/* Fills in the identity of the device, so that you can make macula_shared_memory on the same card. */
MACULA_API macula_status macula_device_identify(macula_device* device, macula_device_identity* identity);

/* Closes a device of macula_device_open or macula_device_lend. Views and live pictures that were opened or
 * drawn with it stay open. */
MACULA_API void macula_device_close(macula_device* device);

#ifdef __cplusplus
}
#endif

#endif
