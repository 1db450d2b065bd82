// A graphics device that is lost, or has no memory left, when a test says so.
//
// Vulkan's own functions are replaced: a program this is linked into, or preloaded to, calls these, and they
// call the loader. All of Macula's code and all of the driver is the real one. From the loss on every
// replaced call on that VkDevice reports VK_ERROR_DEVICE_LOST and does nothing, until the device is
// destroyed.
//
// A false answer is that of a single call, such as a timeout.
//
// Without memory each allocation reports VK_ERROR_OUT_OF_DEVICE_MEMORY; all else goes on.
//
// Preloaded, it takes MACULA_TEST_LOSE=submit:40:2: lost at the 40th submission, and once more 40 later.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>

namespace macula::test {

enum class VulkanCall { submit, wait, query, allocate, compile, acquire, present, create, swapchain };

// At the `nth` such call from now, the first being 1, of any device; then `times` - 1 times more, counted
// anew each time. Replaces what was said before; 0 times: never.
void loseDeviceAt(VulkanCall call, int nth, int times = 1);

// A call that answers something else than it should, and does nothing. The device goes on.
struct FalseAnswer {
    VulkanCall call = VulkanCall::acquire;  // submit, acquire, present or swapchain
    VkResult result = VK_TIMEOUT;
    int times = 1;                  // so many from now on; 0: never
    bool onlyAfterAcquire = false;  // only such calls as follow one that acquired an image
};
void answerFalsely(const FalseAnswer& answer);  // replaces what was said before
int falseAnswersLeft();

// While there is one of these, no device has memory left for an allocation of that size or more. No more than
// one at a time.
class NoMemory {
  public:
    // `untilFreed` not 0: until an allocation of so many bytes at least was freed after one was refused.
    explicit NoMemory(std::uint64_t fromBytes = 0, std::uint64_t untilFreed = 0);
    ~NoMemory();
    NoMemory(const NoMemory&) = delete;
    NoMemory& operator=(const NoMemory&) = delete;

    int refused() const;  // allocations
};

// While there is one of these, all devices together have so many bytes of memory.
class MemoryLimit {
  public:
    explicit MemoryLimit(std::uint64_t bytes);
    ~MemoryLimit();
    MemoryLimit(const MemoryLimit&) = delete;
    MemoryLimit& operator=(const MemoryLimit&) = delete;
};
std::uint64_t allocatedBytes();  // now

int devicesLost();         // since the last loseDeviceAt
int callsOfLostDevice();   // likewise: of replaced functions, on a device that had been lost
int lossesOnThisThread();  // reported to it, ever

// How many such calls there have been since the program began.
int countOf(VulkanCall call);

}  // namespace macula::test
