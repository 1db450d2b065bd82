#include "host_device.h"

#include <string.h>

static uint32_t memory_type(const struct host_device* host, uint32_t allowed, VkMemoryPropertyFlags wanted) {
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
    info.memoryTypeIndex = memory_type(host, needs->memoryTypeBits, wanted);
    return info.memoryTypeIndex != UINT32_MAX &&
           vkAllocateMemory(host->device, &info, NULL, memory) == VK_SUCCESS;
}

/* A queue with compute of the first device that has one, and MACULA's demands: macula_lent_device. */
static int choose(struct host_device* host) {
    VkPhysicalDevice devices[16];
    uint32_t count = 16;
    vkEnumeratePhysicalDevices(host->instance, &count, devices);
    for (uint32_t d = 0; d < count; ++d) {
        VkQueueFamilyProperties families[16];
        uint32_t family_count = 16;
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

static int open_device(struct host_device* host) {
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
    const char* extensions[] = {VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME};
    VkDeviceCreateInfo info = {VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
    info.pNext = &v12;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    info.enabledExtensionCount = 1;
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

int host_open(struct host_device* host, uint32_t width, uint32_t height, const char** what) {
    memset(host, 0, sizeof *host);
    host->width = width;
    host->height = height;
    VkApplicationInfo application = {VK_STRUCTURE_TYPE_APPLICATION_INFO};
    application.pApplicationName = "lend";
    application.apiVersion = VK_API_VERSION_1_3;
    VkInstanceCreateInfo info = {VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    info.pApplicationInfo = &application;
    *what = "no Vulkan driver";
    if (vkCreateInstance(&info, NULL, &host->instance) != VK_SUCCESS) return 0;
    *what = "no device with compute";
    if (!choose(host)) return 0;
    *what = "the device was not opened";
    if (!open_device(host)) return 0;
    *what = "no memory for the image";
    return make_image(host) && make_pixels(host);
}

static int submit_and_wait(struct host_device* host, VkCommandBuffer commands) {
    VkSubmitInfo submit = {VK_STRUCTURE_TYPE_SUBMIT_INFO};
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &commands;
    return vkQueueSubmit(host->queue, 1, &submit, VK_NULL_HANDLE) == VK_SUCCESS &&
           vkQueueWaitIdle(host->queue) == VK_SUCCESS;
}

static int read_image(struct host_device* host, VkCommandPool pool) {
    VkCommandBufferAllocateInfo info = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    info.commandPool = pool;
    info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    info.commandBufferCount = 1;
    VkCommandBuffer commands;
    if (vkAllocateCommandBuffers(host->device, &info, &commands) != VK_SUCCESS) return 0;
    VkCommandBufferBeginInfo begin = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    vkBeginCommandBuffer(commands, &begin);
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
    vkEndCommandBuffer(commands);
    return submit_and_wait(host, commands);
}

const uint8_t* host_pixels(struct host_device* host) {
    VkCommandPoolCreateInfo info = {VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    info.queueFamilyIndex = host->family;
    VkCommandPool pool;
    if (vkCreateCommandPool(host->device, &info, NULL, &pool) != VK_SUCCESS) return NULL;
    const int is_read = read_image(host, pool);
    vkDestroyCommandPool(host->device, pool, NULL);
    void* mapped = NULL;
    if (!is_read ||
        vkMapMemory(host->device, host->pixels_memory, 0, VK_WHOLE_SIZE, 0, &mapped) != VK_SUCCESS)
        return NULL;
    return mapped;
}

void host_unmap(struct host_device* host) {
    vkUnmapMemory(host->device, host->pixels_memory);
}

void host_close(struct host_device* host) {
    vkDestroyBuffer(host->device, host->pixels, NULL);
    vkFreeMemory(host->device, host->pixels_memory, NULL);
    vkDestroyImage(host->device, host->image, NULL);
    vkFreeMemory(host->device, host->image_memory, NULL);
    vkDestroyDevice(host->device, NULL);
    vkDestroyInstance(host->instance, NULL);
}
