/* Devices that draw: of Macula's own, or lent by the host. */
#ifndef MACULA_DEVICE_H
#define MACULA_DEVICE_H

#include <stdint.h>

#include "status.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct macula_device macula_device;

/* By its number or a part of its name; null: MACULA_DEVICE of the environment, or else the best. Without a
 * graphics card, Mesa's lavapipe draws on the CPU. */
MACULA_API macula_status macula_device_open(const char* preferred, macula_device** device);

/* Called before and after each use of a queue, by the thread that uses it. They must not call Macula, nor
 * throw. */
typedef void (*macula_queue_call)(void* user);

/* A device of yours, in place of one of Macula's own: of Vulkan 1.3, with VK_KHR_push_descriptor, and with
 * the features timelineSemaphore, scalarBlockLayout, synchronization2 and maintenance4. Nothing of it is
 * destroyed here; close what was opened with it first. */
typedef struct macula_lent_device {
    uint32_t size;
    uint32_t queue_family; /* of the queue */
    void* instance;        /* VkInstance, made for Vulkan 1.3 */
    void* physical_device; /* VkPhysicalDevice */
    void* device;          /* VkDevice */
    void* queue;           /* VkQueue, with compute */
    /* Null both: you do not use the queue while a call of Macula runs that uses this device, and lend it once
     * at a time. */
    macula_queue_call lock_queue;
    macula_queue_call unlock_queue;
    void* user; /* for both */
} macula_lent_device;
/* As macula_device_open, with that one. */
MACULA_API macula_status macula_device_lend(const macula_lent_device* lent, macula_device** device);

/* Which card and driver a device is of, to every program: VkPhysicalDeviceIDProperties, or GL_DEVICE_UUID_EXT
 * and GL_DRIVER_UUID_EXT. */
typedef struct macula_device_identity {
    uint32_t size;
    uint32_t reserved; /* 0 */
    uint8_t device_uuid[16];
    uint8_t driver_uuid[16];
} macula_device_identity;
/* So that macula_shared_memory can be of the same card. */
MACULA_API macula_status macula_device_identify(macula_device* device, macula_device_identity* identity);

/* Ends what macula_device_open or macula_device_lend began. What is opened or drawn with it goes on until its
 * own close. */
MACULA_API void macula_device_close(macula_device* device);

#ifdef __cplusplus
}
#endif

#endif
