#include "gpu/lose_device.h"

#include <dlfcn.h>
#include <vulkan/vulkan.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

namespace macula::test {
namespace {

constexpr std::array kNames{"submit",  "wait",    "query",  "allocate", "compile",
                            "acquire", "present", "create", "swapchain"};

struct State {
    std::mutex mutex;
    VulkanCall call = VulkanCall::submit;
    int every = 0;
    int left = 0;
    int timesLeft = 0;
    int lost = 0;
    int callsAfter = 0;
    std::array<int, kNames.size()> counts{};
    FalseAnswer falseAnswer{.times = 0};
    bool wasAcquired = false;  // the call before this one was acquire, and it gave an image
    bool isFull = false;
    std::uint64_t refusedFromBytes = 0;
    int refused = 0;
    std::uint64_t untilFreed = 0;
    std::map<VkDeviceMemory, std::uint64_t> allocated;  // bytes
    std::uint64_t allocatedBytes = 0;
    std::uint64_t limitBytes = UINT64_MAX;
    VkDevice lostDevice = VK_NULL_HANDLE;
    std::map<VkQueue, VkDevice> queues;

    void arm(VulkanCall which, int nth, int times) {
        call = which;
        every = left = nth;
        timesLeft = times;
        lost = callsAfter = 0;
    }

    State() {
        const char* wanted = std::getenv("MACULA_TEST_LOSE");
        char name[16] = "";
        int nth = 0;
        int times = 1;
        if (wanted == nullptr || std::sscanf(wanted, "%15[a-z]:%d:%d", name, &nth, &times) < 2) return;
        for (std::size_t i = 0; i < kNames.size(); ++i) {
            if (std::strcmp(name, kNames[i]) == 0) arm(VulkanCall(i), nth, times);
        }
    }
};

thread_local int lossesHere = 0;

State& state() {
    static State instance;
    return instance;
}

// Whether this call reports the loss.
bool isLost(VkDevice device, VulkanCall call) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    ++s.counts[std::size_t(call)];
    if (device != VK_NULL_HANDLE && device == s.lostDevice) {
        ++s.callsAfter;
        return true;
    }
    if (s.timesLeft == 0 || call != s.call || --s.left > 0) return false;
    s.left = s.every;
    --s.timesLeft;
    ++s.lost;
    ++lossesHere;
    if (device != VK_NULL_HANDLE) s.lostDevice = device;
    return true;
}

// What to answer instead of doing it; nothing when it is to be done.
std::optional<VkResult> falseAnswerTo(VulkanCall call) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    const bool follows = std::exchange(s.wasAcquired, false);
    FalseAnswer& answer = s.falseAnswer;
    if (answer.times == 0 || call != answer.call || (answer.onlyAfterAcquire && !follows))
        return std::nullopt;
    --answer.times;
    return answer.result;
}

bool isRefused(std::uint64_t bytes) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    const bool is = (s.isFull && bytes >= s.refusedFromBytes) ||
                    (s.limitBytes < UINT64_MAX && s.allocatedBytes + bytes > s.limitBytes);
    s.refused += is ? 1 : 0;
    return is;
}

void noteAllocated(VkDeviceMemory memory, std::uint64_t bytes) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    s.allocated[memory] = bytes;
    s.allocatedBytes += bytes;
}

// Before it is, because another thread may be given the same handle at once.
void noteFreed(VkDeviceMemory memory) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    const auto found = s.allocated.find(memory);
    if (found == s.allocated.end()) return;
    if (s.untilFreed > 0 && s.refused > 0 && found->second >= s.untilFreed) s.isFull = false;
    s.allocatedBytes -= found->second;
    s.allocated.erase(found);
}

VkDevice deviceOf(VkQueue queue) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    return s.queues[queue];
}

template <class Function>
Function next(Function, const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

void loseDeviceAt(VulkanCall call, int nth, int times) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    s.arm(call, nth, times);
}

void answerFalsely(const FalseAnswer& answer) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    s.falseAnswer = answer;
}

int falseAnswersLeft() {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    return s.falseAnswer.times;
}

NoMemory::NoMemory(std::uint64_t fromBytes, std::uint64_t untilFreed) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    s.isFull = true;
    s.refusedFromBytes = fromBytes;
    s.refused = 0;
    s.untilFreed = untilFreed;
}

NoMemory::~NoMemory() {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    s.isFull = false;
}

int NoMemory::refused() const {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    return s.refused;
}

MemoryLimit::MemoryLimit(std::uint64_t bytes) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    s.limitBytes = bytes;
}

MemoryLimit::~MemoryLimit() {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    s.limitBytes = UINT64_MAX;
}

std::uint64_t allocatedBytes() {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    return s.allocatedBytes;
}

int devicesLost() {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    return s.lost;
}

int lossesOnThisThread() {
    return lossesHere;
}

int callsOfLostDevice() {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    return s.callsAfter;
}

int countOf(VulkanCall call) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    return s.counts[std::size_t(call)];
}

}  // namespace macula::test

using macula::test::VulkanCall;

#define MACULA_NEXT(function) macula::test::next(&function, #function)

extern "C" {

VKAPI_ATTR VkResult VKAPI_CALL vkCreateDevice(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                              const VkAllocationCallbacks* callbacks, VkDevice* device) {
    if (macula::test::isLost(VK_NULL_HANDLE, VulkanCall::create)) return VK_ERROR_DEVICE_LOST;
    return MACULA_NEXT(vkCreateDevice)(physical, info, callbacks, device);
}

VKAPI_ATTR void VKAPI_CALL vkGetDeviceQueue(VkDevice device, uint32_t family, uint32_t index,
                                            VkQueue* queue) {
    MACULA_NEXT(vkGetDeviceQueue)(device, family, index, queue);
    auto& s = macula::test::state();
    const std::lock_guard lock(s.mutex);
    s.queues[*queue] = device;
}

VKAPI_ATTR void VKAPI_CALL vkDestroyDevice(VkDevice device, const VkAllocationCallbacks* callbacks) {
    {
        auto& s = macula::test::state();
        const std::lock_guard lock(s.mutex);
        if (s.lostDevice == device) s.lostDevice = VK_NULL_HANDLE;  // the next may have the same address
    }
    MACULA_NEXT(vkDestroyDevice)(device, callbacks);
}

VKAPI_ATTR VkResult VKAPI_CALL vkQueueSubmit2(VkQueue queue, uint32_t count, const VkSubmitInfo2* submits,
                                              VkFence fence) {
    if (macula::test::isLost(macula::test::deviceOf(queue), VulkanCall::submit)) return VK_ERROR_DEVICE_LOST;
    if (const auto answer = macula::test::falseAnswerTo(VulkanCall::submit)) return *answer;
    return MACULA_NEXT(vkQueueSubmit2)(queue, count, submits, fence);
}

VKAPI_ATTR VkResult VKAPI_CALL vkWaitSemaphores(VkDevice device, const VkSemaphoreWaitInfo* info,
                                                uint64_t timeout) {
    if (macula::test::isLost(device, VulkanCall::wait)) return VK_ERROR_DEVICE_LOST;
    return MACULA_NEXT(vkWaitSemaphores)(device, info, timeout);
}

VKAPI_ATTR VkResult VKAPI_CALL vkGetSemaphoreCounterValue(VkDevice device, VkSemaphore semaphore,
                                                          uint64_t* value) {
    if (macula::test::isLost(device, VulkanCall::query)) return VK_ERROR_DEVICE_LOST;
    return MACULA_NEXT(vkGetSemaphoreCounterValue)(device, semaphore, value);
}

VKAPI_ATTR VkResult VKAPI_CALL vkAllocateMemory(VkDevice device, const VkMemoryAllocateInfo* info,
                                                const VkAllocationCallbacks* callbacks,
                                                VkDeviceMemory* memory) {
    if (macula::test::isLost(device, VulkanCall::allocate)) return VK_ERROR_DEVICE_LOST;
    if (macula::test::isRefused(info->allocationSize)) return VK_ERROR_OUT_OF_DEVICE_MEMORY;
    const VkResult result = MACULA_NEXT(vkAllocateMemory)(device, info, callbacks, memory);
    if (result == VK_SUCCESS) macula::test::noteAllocated(*memory, info->allocationSize);
    return result;
}

VKAPI_ATTR void VKAPI_CALL vkFreeMemory(VkDevice device, VkDeviceMemory memory,
                                        const VkAllocationCallbacks* callbacks) {
    macula::test::noteFreed(memory);
    MACULA_NEXT(vkFreeMemory)(device, memory, callbacks);
}

VKAPI_ATTR VkResult VKAPI_CALL vkCreateComputePipelines(VkDevice device, VkPipelineCache cache,
                                                        uint32_t count,
                                                        const VkComputePipelineCreateInfo* infos,
                                                        const VkAllocationCallbacks* callbacks,
                                                        VkPipeline* pipelines) {
    if (macula::test::isLost(device, VulkanCall::compile)) return VK_ERROR_DEVICE_LOST;
    return MACULA_NEXT(vkCreateComputePipelines)(device, cache, count, infos, callbacks, pipelines);
}

VKAPI_ATTR VkResult VKAPI_CALL vkAcquireNextImageKHR(VkDevice device, VkSwapchainKHR swapchain,
                                                     uint64_t timeout, VkSemaphore semaphore, VkFence fence,
                                                     uint32_t* index) {
    if (macula::test::isLost(device, VulkanCall::acquire)) return VK_ERROR_DEVICE_LOST;
    if (const auto answer = macula::test::falseAnswerTo(VulkanCall::acquire)) return *answer;
    const VkResult result =
        MACULA_NEXT(vkAcquireNextImageKHR)(device, swapchain, timeout, semaphore, fence, index);
    auto& s = macula::test::state();
    const std::lock_guard lock(s.mutex);
    s.wasAcquired = result == VK_SUCCESS || result == VK_SUBOPTIMAL_KHR;
    return result;
}

VKAPI_ATTR VkResult VKAPI_CALL vkCreateSwapchainKHR(VkDevice device, const VkSwapchainCreateInfoKHR* info,
                                                    const VkAllocationCallbacks* callbacks,
                                                    VkSwapchainKHR* swapchain) {
    if (macula::test::isLost(device, VulkanCall::swapchain)) return VK_ERROR_DEVICE_LOST;
    if (const auto answer = macula::test::falseAnswerTo(VulkanCall::swapchain)) return *answer;
    return MACULA_NEXT(vkCreateSwapchainKHR)(device, info, callbacks, swapchain);
}

VKAPI_ATTR VkResult VKAPI_CALL vkQueuePresentKHR(VkQueue queue, const VkPresentInfoKHR* info) {
    if (macula::test::isLost(macula::test::deviceOf(queue), VulkanCall::present)) return VK_ERROR_DEVICE_LOST;
    if (const auto answer = macula::test::falseAnswerTo(VulkanCall::present)) return *answer;
    return MACULA_NEXT(vkQueuePresentKHR)(queue, info);
}

}  // extern "C"
