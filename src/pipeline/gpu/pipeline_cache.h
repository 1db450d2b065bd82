// What the driver has compiled, kept in a file for the next start: a graphics card's driver takes about a
// second for all of Macula's kernels.
#pragma once

#include <vulkan/vulkan_core.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace macula::gpu {

// The file of a device, its driver and this version of Macula, in that folder.
std::filesystem::path kernelsFile(VkPhysicalDevice physical, const std::filesystem::path& folder);

// What such a file holds: drivers trust what they are given, so nothing reaches one that is not as it was
// written. Nothing of a file that is cut short, changed, or of something else.
std::string sealedKernels(std::string_view data);
std::optional<std::string> unsealedKernels(std::string_view file);
// Whether a cache of this device and driver wrote it (VkPipelineCacheHeaderVersionOne).
bool isOfDriver(std::string_view data, const VkPhysicalDeviceProperties& driver);

// A VkPipelineCache. What cannot be read or written is no error: kernels are compiled then.
class PipelineCache {
  public:
    // Null when the driver has none to give.
    static std::unique_ptr<PipelineCache> open(VkDevice device, VkPhysicalDevice physical,
                                               const std::filesystem::path& folder);

    PipelineCache(const PipelineCache&) = delete;
    PipelineCache& operator=(const PipelineCache&) = delete;

    VkPipelineCache handle() const { return cache_; }
    // Whether no file held anything of this device, its driver and this version.
    bool beganEmpty() const { return beganEmpty_; }
    // Before the device goes: writes the file when anything is new and `keeps`. Throws nothing.
    void close(bool keeps) noexcept;

  private:
    PipelineCache(VkDevice device, VkPipelineCache cache, std::filesystem::path file, std::string read,
                  bool beganEmpty)
        : device_(device),
          cache_(cache),
          file_(std::move(file)),
          read_(std::move(read)),
          beganEmpty_(beganEmpty) {}
    void write() const;

    VkDevice device_;
    VkPipelineCache cache_;
    std::filesystem::path file_;
    std::string read_;  // what the file held, sealed
    bool beganEmpty_;
};

}  // namespace macula::gpu
