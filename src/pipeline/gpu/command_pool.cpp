#include "pipeline/gpu/command_pool.h"

#include <algorithm>

namespace macula::gpu {

namespace {

using Commands = CommandPool::Commands;

void destroyCommands(VkDevice device, const Commands& commands) {
    if (commands.queries) vkDestroyQueryPool(device, commands.queries, nullptr);
    if (commands.pool) vkDestroyCommandPool(device, commands.pool, nullptr);
}

VkResult makeCommands(VkDevice device, std::uint32_t queueFamily, Commands& commands) {
    VkCommandPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    poolInfo.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
    poolInfo.queueFamilyIndex = queueFamily;
    if (const VkResult result = vkCreateCommandPool(device, &poolInfo, nullptr, &commands.pool); result < 0)
        return result;

    VkCommandBufferAllocateInfo bufferInfo{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    bufferInfo.commandPool = commands.pool;
    bufferInfo.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    bufferInfo.commandBufferCount = 1;
    if (const VkResult result = vkAllocateCommandBuffers(device, &bufferInfo, &commands.buffer); result < 0)
        return result;

    VkQueryPoolCreateInfo queryInfo{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
    queryInfo.queryType = VK_QUERY_TYPE_TIMESTAMP;
    queryInfo.queryCount = CommandPool::kQueries;
    return vkCreateQueryPool(device, &queryInfo, nullptr, &commands.queries);
}

}  // namespace

VkResult CommandPool::take(VkDevice device, std::uint32_t queueFamily, Ticket completed, Commands& commands) {
    const auto idle = std::find_if(free_.begin(), free_.end(),
                                   [&](const Commands& each) { return each.busyUntil <= completed; });
    if (idle != free_.end()) {
        commands = *idle;
        free_.erase(idle);
        vkResetCommandPool(device, commands.pool, 0);
        return VK_SUCCESS;
    }
    commands = {};
    const VkResult result = makeCommands(device, queueFamily, commands);
    if (result < 0) destroyCommands(device, commands);
    return result;
}

void CommandPool::destroyAll(VkDevice device) {
    for (const Commands& commands : free_) destroyCommands(device, commands);
}

}  // namespace macula::gpu
