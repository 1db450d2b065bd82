#include "host_share.h"

static const VkExternalMemoryHandleTypeFlagBits memory_handle = VK_EXTERNAL_MEMORY_HANDLE_TYPE_OPAQUE_FD_BIT;
static const VkExternalSemaphoreHandleTypeFlagBits semaphore_handle =
    VK_EXTERNAL_SEMAPHORE_HANDLE_TYPE_OPAQUE_FD_BIT;

static int make_image(struct host_device* host, const struct host_share* share) {
    VkExternalMemoryImageCreateInfo external = {VK_STRUCTURE_TYPE_EXTERNAL_MEMORY_IMAGE_CREATE_INFO};
    external.handleTypes = memory_handle;
    VkImageCreateInfo info = {VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
    info.pNext = &external;
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = share->format;
    info.extent.width = host->width;
    info.extent.height = host->height;
    info.extent.depth = 1;
    info.mipLevels = 1;
    info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.tiling = share->tiling;
    info.usage = share->usage;
    return vkCreateImage(host->device, &info, NULL, &host->image) == VK_SUCCESS;
}

static int make_memory(struct host_device* host, struct host_share* share) {
    VkImageMemoryRequirementsInfo2 of = {VK_STRUCTURE_TYPE_IMAGE_MEMORY_REQUIREMENTS_INFO_2};
    of.image = host->image;
    VkMemoryDedicatedRequirements wants = {VK_STRUCTURE_TYPE_MEMORY_DEDICATED_REQUIREMENTS};
    VkMemoryRequirements2 requirements = {VK_STRUCTURE_TYPE_MEMORY_REQUIREMENTS_2};
    requirements.pNext = &wants;
    vkGetImageMemoryRequirements2(host->device, &of, &requirements);
    const VkMemoryRequirements needs = requirements.memoryRequirements;
    if (wants.requiresDedicatedAllocation) share->is_dedicated = 1;
    if (share->is_dedicated) share->offset = 0;
    share->offset = (share->offset + needs.alignment - 1) / needs.alignment * needs.alignment;
    share->bytes = share->offset + needs.size;
    share->memory_type = host_memory_type(host, needs.memoryTypeBits, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    if (share->memory_type == UINT32_MAX) return 0;
    VkMemoryDedicatedAllocateInfo dedicated = {VK_STRUCTURE_TYPE_MEMORY_DEDICATED_ALLOCATE_INFO};
    dedicated.image = host->image;
    VkExportMemoryAllocateInfo exported = {VK_STRUCTURE_TYPE_EXPORT_MEMORY_ALLOCATE_INFO};
    exported.handleTypes = memory_handle;
    if (share->is_dedicated) exported.pNext = &dedicated;
    VkMemoryAllocateInfo info = {VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
    info.pNext = &exported;
    info.allocationSize = share->bytes;
    info.memoryTypeIndex = share->memory_type;
    return vkAllocateMemory(host->device, &info, NULL, &host->image_memory) == VK_SUCCESS &&
           vkBindImageMemory(host->device, host->image, host->image_memory, share->offset) == VK_SUCCESS;
}

int host_can_share(const struct host_device* host, const struct host_share* share) {
    VkPhysicalDeviceExternalImageFormatInfo external = {
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_EXTERNAL_IMAGE_FORMAT_INFO};
    external.handleType = memory_handle;
    VkPhysicalDeviceImageFormatInfo2 info = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_IMAGE_FORMAT_INFO_2};
    info.pNext = &external;
    info.format = share->format;
    info.type = VK_IMAGE_TYPE_2D;
    info.tiling = share->tiling;
    info.usage = share->usage;
    VkExternalImageFormatProperties can = {VK_STRUCTURE_TYPE_EXTERNAL_IMAGE_FORMAT_PROPERTIES};
    VkImageFormatProperties2 properties = {VK_STRUCTURE_TYPE_IMAGE_FORMAT_PROPERTIES_2};
    properties.pNext = &can;
    if (vkGetPhysicalDeviceImageFormatProperties2(host->physical, &info, &properties) != VK_SUCCESS) return 0;
    const VkExternalMemoryFeatureFlags features = can.externalMemoryProperties.externalMemoryFeatures;
    if ((features & VK_EXTERNAL_MEMORY_FEATURE_DEDICATED_ONLY_BIT) && !share->is_dedicated) return 0;
    return (features & VK_EXTERNAL_MEMORY_FEATURE_EXPORTABLE_BIT) != 0;
}

static void give_away(struct host_device* host, VkCommandBuffer commands) {
    host_pass(host, commands, VK_IMAGE_LAYOUT_UNDEFINED, VK_QUEUE_FAMILY_IGNORED, VK_QUEUE_FAMILY_IGNORED);
    host_pass(host, commands, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, host->family, VK_QUEUE_FAMILY_EXTERNAL);
}

int host_share_image(struct host_device* host, struct host_share* share) {
    host->is_shared = host_can_share(host, share) && make_image(host, share) && make_memory(host, share) &&
                      host_run(host, give_away);
    return host->is_shared;
}

int host_memory_fd(struct host_device* host) {
    const PFN_vkGetMemoryFdKHR get =
        (PFN_vkGetMemoryFdKHR)vkGetDeviceProcAddr(host->device, "vkGetMemoryFdKHR");
    VkMemoryGetFdInfoKHR info = {VK_STRUCTURE_TYPE_MEMORY_GET_FD_INFO_KHR};
    info.memory = host->image_memory;
    info.handleType = memory_handle;
    int fd = -1;
    return get && get(host->device, &info, &fd) == VK_SUCCESS ? fd : -1;
}

int host_make_semaphore(struct host_device* host, VkSemaphore* semaphore) {
    VkExportSemaphoreCreateInfo exported = {VK_STRUCTURE_TYPE_EXPORT_SEMAPHORE_CREATE_INFO};
    exported.handleTypes = semaphore_handle;
    VkSemaphoreCreateInfo info = {VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
    info.pNext = &exported;
    return vkCreateSemaphore(host->device, &info, NULL, semaphore) == VK_SUCCESS;
}

int host_semaphore_fd(struct host_device* host, VkSemaphore semaphore) {
    const PFN_vkGetSemaphoreFdKHR get =
        (PFN_vkGetSemaphoreFdKHR)vkGetDeviceProcAddr(host->device, "vkGetSemaphoreFdKHR");
    VkSemaphoreGetFdInfoKHR info = {VK_STRUCTURE_TYPE_SEMAPHORE_GET_FD_INFO_KHR};
    info.semaphore = semaphore;
    info.handleType = semaphore_handle;
    int fd = -1;
    return get && get(host->device, &info, &fd) == VK_SUCCESS ? fd : -1;
}

int host_submit(struct host_device* host, VkSemaphore wait, VkSemaphore signal) {
    const VkPipelineStageFlags stage = VK_PIPELINE_STAGE_ALL_COMMANDS_BIT;
    VkSubmitInfo info = {VK_STRUCTURE_TYPE_SUBMIT_INFO};
    info.waitSemaphoreCount = wait ? 1 : 0;
    info.pWaitSemaphores = &wait;
    info.pWaitDstStageMask = &stage;
    info.signalSemaphoreCount = signal ? 1 : 0;
    info.pSignalSemaphores = &signal;
    return vkQueueSubmit(host->queue, 1, &info, VK_NULL_HANDLE) == VK_SUCCESS;
}
