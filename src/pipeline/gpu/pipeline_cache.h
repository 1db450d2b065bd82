// Keeps the driver's compiled kernels in a file for the next start: the driver of a graphics card takes about
// a second to compile all of Macula's kernels.
#pragma once

#include <vulkan/vulkan_core.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace macula::gpu {

// The file in `folder` for a device, its driver and this version of Macula.
std::filesystem::path kernelsFile(VkPhysicalDevice physical, const std::filesystem::path& folder);

// The content of such a file: the data behind a digest, because drivers trust the data that they are given.
// unsealedKernels returns nothing for a file that is cut short, changed, or of another kind.
std::string sealedKernels(std::string_view data);
std::optional<std::string> unsealedKernels(std::string_view file);
// Whether a cache of this device and driver wrote the data (VkPipelineCacheHeaderVersionOne).
bool isOfDriver(std::string_view data, const VkPhysicalDeviceProperties& driver);

// A VkPipelineCache. A file that cannot be read or written is not an error: the kernels are compiled instead.
class PipelineCache {
  public:
    // Null when the driver cannot create one.
    static std::unique_ptr<PipelineCache> open(VkDevice device, VkPhysicalDevice physical,
                                               const std::filesystem::path& folder);

    PipelineCache(const PipelineCache&) = delete;
    PipelineCache& operator=(const PipelineCache&) = delete;

    VkPipelineCache handle() const { return cache_; }
    // Whether no file held data for this device, its driver and this version.
    bool beganEmpty() const { return beganEmpty_; }
    // Call before the device is destroyed: writes the file if the data changed and `keeps` is true. Throws
    // nothing.
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
    std::string read_;  // the content of the file, sealed
    bool beganEmpty_;
};

}  // namespace macula::gpu
