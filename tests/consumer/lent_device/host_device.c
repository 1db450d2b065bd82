#include "host_device.h"

#include <string.h>

uint32_t host_memory_type(const struct host_device* host, uint32_t allowed, VkMemoryPropertyFlags wanted) {
    VkPhysicalDeviceMemoryProperties memory;
    vkGetPhysicalDeviceMemoryProperties(host->physical, &memory);
    for (uint32_t i = 0; i < memory.memoryTypeCount; ++i)
        if ((allowed >> i & 1) && (memory.memoryTypes[i].propertyFlags & wanted) == wanted) return i;
    return UINT32_MAX;
}

static int allocate(const struct host_device* host, const VkMemoryRequirements* needs,
                    VkMemoryPropertyFlags wanted, VkDeviceMemory* memory) {
    VkMemoryAllocateInfo info = {VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
    info.allocationSize = needs->size;
    info.memoryTypeIndex = host_memory_type(host, needs->memoryTypeBits, wanted);
    return info.memoryTypeIndex != UINT32_MAX &&
           vkAllocateMemory(host->device, &info, NULL, memory) == VK_SUCCESS;
}

static int is_card(VkPhysicalDevice physical, const uint8_t* device_uuid, const uint8_t* driver_uuid) {
    VkPhysicalDeviceIDProperties ids = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ID_PROPERTIES};
    VkPhysicalDeviceProperties2 properties = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
    properties.pNext = &ids;
    vkGetPhysicalDeviceProperties2(physical, &properties);
    return memcmp(ids.deviceUUID, device_uuid, VK_UUID_SIZE) == 0 &&
           memcmp(ids.driverUUID, driver_uuid, VK_UUID_SIZE) == 0;
}

/* A queue with compute of the first device that has one, or of the card, and MACULA's demands:
 * macula_lent_device. */
static int choose(struct host_device* host, const uint8_t* device_uuid, const uint8_t* driver_uuid) {
    VkPhysicalDevice devices[16];
    uint32_t count = 16;
    vkEnumeratePhysicalDevices(host->instance, &count, devices);
    for (uint32_t d = 0; d < count; ++d) {
        VkQueueFamilyProperties families[16];
        uint32_t family_count = 16;
        if (device_uuid && !is_card(devices[d], device_uuid, driver_uuid)) continue;
        vkGetPhysicalDeviceQueueFamilyProperties(devices[d], &family_count, families);
        for (uint32_t f = 0; f < family_count; ++f) {
            if (!(families[f].queueFlags & VK_QUEUE_COMPUTE_BIT)) continue;
            host->physical = devices[d];
            host->family = f;
            return 1;
        }
    }
    return 0;
}

static int offers(VkPhysicalDevice physical, const char* extension) {
    VkExtensionProperties all[512];
    uint32_t count = 512;
    vkEnumerateDeviceExtensionProperties(physical, NULL, &count, all);
    for (uint32_t i = 0; i < count; ++i)
        if (strcmp(all[i].extensionName, extension) == 0) return 1;
    return 0;
}

/* Both ways, by opaque file descriptors: a driver may offer the extension for those of other kinds. */
static int shares_semaphores(VkPhysicalDevice physical) {
    VkPhysicalDeviceExternalSemaphoreInfo info = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_EXTERNAL_SEMAPHORE_INFO};
    info.handleType = VK_EXTERNAL_SEMAPHORE_HANDLE_TYPE_OPAQUE_FD_BIT;
    VkExternalSemaphoreProperties can = {VK_STRUCTURE_TYPE_EXTERNAL_SEMAPHORE_PROPERTIES};
    vkGetPhysicalDeviceExternalSemaphoreProperties(physical, &info, &can);
    const VkExternalSemaphoreFeatureFlags both =
        VK_EXTERNAL_SEMAPHORE_FEATURE_EXPORTABLE_BIT | VK_EXTERNAL_SEMAPHORE_FEATURE_IMPORTABLE_BIT;
    return (can.externalSemaphoreFeatures & both) == both &&
           offers(physical, VK_KHR_EXTERNAL_SEMAPHORE_FD_EXTENSION_NAME);
}

static int open_device(struct host_device* host, int shares) {
    VkPhysicalDeviceVulkan13Features v13 = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
    v13.synchronization2 = VK_TRUE;
    v13.maintenance4 = VK_TRUE;
    VkPhysicalDeviceVulkan12Features v12 = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
    v12.pNext = &v13;
    v12.timelineSemaphore = VK_TRUE;
    v12.scalarBlockLayout = VK_TRUE;
    const float priority = 1.0f;
    VkDeviceQueueCreateInfo queue = {VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
    queue.queueFamilyIndex = host->family;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    const char* extensions[3] = {VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME};
    uint32_t extension_count = 1;
    if (shares) extensions[extension_count++] = VK_KHR_EXTERNAL_MEMORY_FD_EXTENSION_NAME;
    if (shares && shares_semaphores(host->physical)) {
        extensions[extension_count++] = VK_KHR_EXTERNAL_SEMAPHORE_FD_EXTENSION_NAME;
        host->has_semaphores = 1;
    }
    VkDeviceCreateInfo info = {VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
    info.pNext = &v12;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    info.enabledExtensionCount = extension_count;
    info.ppEnabledExtensionNames = extensions;
    if (vkCreateDevice(host->physical, &info, NULL, &host->device) != VK_SUCCESS) return 0;
    vkGetDeviceQueue(host->device, host->family, 0, &host->queue);
    return 1;
}

static int make_image(struct host_device* host) {
    VkImageCreateInfo info = {VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = VK_FORMAT_R8G8B8A8_SRGB;
    info.extent.width = host->width;
    info.extent.height = host->height;
    info.extent.depth = 1;
    info.mipLevels = 1;
    info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.usage = VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    VkMemoryRequirements needs;
    if (vkCreateImage(host->device, &info, NULL, &host->image) != VK_SUCCESS) return 0;
    vkGetImageMemoryRequirements(host->device, host->image, &needs);
    if (!allocate(host, &needs, 0, &host->image_memory)) return 0;
    return vkBindImageMemory(host->device, host->image, host->image_memory, 0) == VK_SUCCESS;
}

static int make_pixels(struct host_device* host) {
    VkBufferCreateInfo info = {VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
    info.size = 4 * (VkDeviceSize)host->width * host->height;
    info.usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    VkMemoryRequirements needs;
    if (vkCreateBuffer(host->device, &info, NULL, &host->pixels) != VK_SUCCESS) return 0;
    vkGetBufferMemoryRequirements(host->device, host->pixels, &needs);
    if (!allocate(host, &needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT,
                  &host->pixels_memory))
        return 0;
    return vkBindBufferMemory(host->device, host->pixels, host->pixels_memory, 0) == VK_SUCCESS;
}

static int open_on(struct host_device* host, uint32_t width, uint32_t height, const uint8_t* device_uuid,
                   const uint8_t* driver_uuid, const char** what) {
    memset(host, 0, sizeof *host);
    host->width = width;
    host->height = height;
    VkApplicationInfo application = {VK_STRUCTURE_TYPE_APPLICATION_INFO};
    application.pApplicationName = "a host of Macula";
    application.apiVersion = VK_API_VERSION_1_3;
    VkInstanceCreateInfo info = {VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    info.pApplicationInfo = &application;
    *what = "no Vulkan driver";
    if (vkCreateInstance(&info, NULL, &host->instance) != VK_SUCCESS) return 0;
    *what = "no device with compute, or not the one that was asked for";
    if (!choose(host, device_uuid, driver_uuid)) return 0;
    *what = "the device was not opened";
    if (!open_device(host, device_uuid != NULL)) return 0;
    *what = "no memory for the pixels";
    return make_pixels(host);
}

int host_open(struct host_device* host, uint32_t width, uint32_t height, const char** what) {
    if (!open_on(host, width, height, NULL, NULL, what)) return 0;
    *what = "no memory for the image";
    return make_image(host);
}

int host_open_on(struct host_device* host, uint32_t width, uint32_t height, const uint8_t device_uuid[16],
                 const uint8_t driver_uuid[16], const char** what) {
    return open_on(host, width, height, device_uuid, driver_uuid, what);
}

static int run_in(struct host_device* host, VkCommandPool pool, host_commands record) {
    VkCommandBufferAllocateInfo info = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    info.commandPool = pool;
    info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    info.commandBufferCount = 1;
    VkCommandBuffer commands;
    if (vkAllocateCommandBuffers(host->device, &info, &commands) != VK_SUCCESS) return 0;
    VkCommandBufferBeginInfo begin = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    vkBeginCommandBuffer(commands, &begin);
    record(host, commands);
    if (vkEndCommandBuffer(commands) != VK_SUCCESS) return 0;
    VkSubmitInfo submit = {VK_STRUCTURE_TYPE_SUBMIT_INFO};
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &commands;
    return vkQueueSubmit(host->queue, 1, &submit, VK_NULL_HANDLE) == VK_SUCCESS &&
           vkQueueWaitIdle(host->queue) == VK_SUCCESS;
}

int host_run(struct host_device* host, host_commands record) {
    VkCommandPoolCreateInfo info = {VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    info.queueFamilyIndex = host->family;
    VkCommandPool pool;
    if (vkCreateCommandPool(host->device, &info, NULL, &pool) != VK_SUCCESS) return 0;
    const int is_run = run_in(host, pool, record);
    vkDestroyCommandPool(host->device, pool, NULL);
    return is_run;
}

void host_pass(struct host_device* host, VkCommandBuffer commands, VkImageLayout before, uint32_t from,
               uint32_t to) {
    VkImageMemoryBarrier barrier = {VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
    barrier.srcAccessMask = from == host->family ? VK_ACCESS_MEMORY_READ_BIT : 0;
    barrier.dstAccessMask = to == host->family ? VK_ACCESS_TRANSFER_READ_BIT : 0;
    barrier.oldLayout = before;
    barrier.newLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    barrier.srcQueueFamilyIndex = from;
    barrier.dstQueueFamilyIndex = to;
    barrier.image = host->image;
    barrier.subresourceRange.aspectMask = VK_IMAGE_ASPECT_COLOR_BIT;
    barrier.subresourceRange.levelCount = 1;
    barrier.subresourceRange.layerCount = 1;
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0,
                         0, NULL, 0, NULL, 1, &barrier);
}

static void read_image(struct host_device* host, VkCommandBuffer commands) {
    if (host->is_shared)
        host_pass(host, commands, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_QUEUE_FAMILY_EXTERNAL,
                  host->family);
    VkBufferImageCopy region;
    memset(&region, 0, sizeof region);
    region.imageSubresource.aspectMask = VK_IMAGE_ASPECT_COLOR_BIT;
    region.imageSubresource.layerCount = 1;
    region.imageExtent.width = host->width;
    region.imageExtent.height = host->height;
    region.imageExtent.depth = 1;
    vkCmdCopyImageToBuffer(commands, host->image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, host->pixels, 1,
                           &region);
    VkMemoryBarrier barrier = {VK_STRUCTURE_TYPE_MEMORY_BARRIER};
    barrier.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &barrier,
                         0, NULL, 0, NULL);
    if (host->is_shared)
        host_pass(host, commands, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, host->family,
                  VK_QUEUE_FAMILY_EXTERNAL);
}

const uint8_t* host_pixels(struct host_device* host) {
    void* mapped = NULL;
    if (!host_run(host, read_image) ||
        vkMapMemory(host->device, host->pixels_memory, 0, VK_WHOLE_SIZE, 0, &mapped) != VK_SUCCESS)
        return NULL;
    return mapped;
}

void host_unmap(struct host_device* host) {
    vkUnmapMemory(host->device, host->pixels_memory);
}

void host_close(struct host_device* host) {
    if (host->device) {
        vkDestroyBuffer(host->device, host->pixels, NULL);
        vkFreeMemory(host->device, host->pixels_memory, NULL);
        vkDestroyImage(host->device, host->image, NULL);
        vkFreeMemory(host->device, host->image_memory, NULL);
        vkDestroyDevice(host->device, NULL);
    }
    if (host->instance) vkDestroyInstance(host->instance, NULL);
}
