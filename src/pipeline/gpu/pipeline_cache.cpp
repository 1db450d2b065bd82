#include "pipeline/gpu/pipeline_cache.h"

#include <algorithm>
#include <cstring>
#include <exception>
#include <system_error>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "base/log.h"
#include "base/sha256.h"

namespace macula::gpu {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMagic = "Macula kernels 1\n";
constexpr std::size_t kDigestLetters = 64;
constexpr std::size_t kMostBytes = std::size_t(256) << 20;
constexpr std::size_t kMostFiles = 8;  // one for each device, driver and version
constexpr const char* kExtension = ".kernels";

template <class T>
std::string_view bytesOf(const T& value) {
    return {reinterpret_cast<const char*>(&value), sizeof(value)};
}

// Removes all files but the newest: files of earlier drivers and versions are never read again.
void removeOldFiles(const fs::path& folder) {
    std::vector<std::pair<fs::file_time_type, fs::path>> files;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        if (entry->path().extension() != kExtension || !entry->is_regular_file(error)) continue;
        const auto written = entry->last_write_time(error);
        if (!error) files.emplace_back(written, entry->path());
    }
    std::sort(files.begin(), files.end());
    for (std::size_t i = 0; i + kMostFiles < files.size(); ++i) fs::remove(files[i].second, error);
}

void makeFolder(const fs::path& folder) {
    std::error_code error;
    if (fs::create_directories(folder, error) && !error) fs::permissions(folder, fs::perms::owner_all, error);
}

}  // namespace

fs::path kernelsFile(VkPhysicalDevice physical, const fs::path& folder) {
    VkPhysicalDeviceIDProperties ids{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ID_PROPERTIES};
    VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &ids, {}};
    vkGetPhysicalDeviceProperties2(physical, &properties);
    std::string key(MACULA_VERSION);
    key += bytesOf(ids.deviceUUID);
    key += bytesOf(ids.driverUUID);
    key += bytesOf(properties.properties.driverVersion);
    key += bytesOf(properties.properties.pipelineCacheUUID);
    return folder / (sha256Hex(key).substr(0, 32) + kExtension);
}

std::string sealedKernels(std::string_view data) {
    std::string file(kMagic);
    file += sha256Hex(data);
    file += data;
    return file;
}

std::optional<std::string> unsealedKernels(std::string_view file) {
    if (file.size() < kMagic.size() + kDigestLetters || !file.starts_with(kMagic)) return std::nullopt;
    const std::string_view digest = file.substr(kMagic.size(), kDigestLetters);
    const std::string_view data = file.substr(kMagic.size() + kDigestLetters);
    if (sha256Hex(data) != digest) return std::nullopt;
    return std::string(data);
}

bool isOfDriver(std::string_view data, const VkPhysicalDeviceProperties& driver) {
    VkPipelineCacheHeaderVersionOne header{};
    if (data.size() < sizeof(header)) return false;
    std::memcpy(&header, data.data(), sizeof(header));
    return header.headerSize >= sizeof(header) && header.headerSize <= data.size() &&
           header.headerVersion == VK_PIPELINE_CACHE_HEADER_VERSION_ONE &&
           header.vendorID == driver.vendorID && header.deviceID == driver.deviceID &&
           std::memcmp(header.pipelineCacheUUID, driver.pipelineCacheUUID, VK_UUID_SIZE) == 0;
}

std::unique_ptr<PipelineCache> PipelineCache::open(VkDevice device, VkPhysicalDevice physical,
                                                   const fs::path& folder) {
    VkPhysicalDeviceProperties driver{};
    vkGetPhysicalDeviceProperties(physical, &driver);
    fs::path file = kernelsFile(physical, folder);
    std::string read;
    std::string data;
    if (Result<std::string> text = readText(file, kMostBytes)) {
        read = *std::move(text);
        if (auto unsealed = unsealedKernels(read); unsealed && isOfDriver(*unsealed, driver))
            data = *std::move(unsealed);
    }
    VkPipelineCacheCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO};
    info.initialDataSize = data.size();
    info.pInitialData = data.empty() ? nullptr : data.data();
    VkPipelineCache cache = VK_NULL_HANDLE;
    VkResult made = vkCreatePipelineCache(device, &info, nullptr, &cache);
    if (made < 0 && !data.empty()) {  // the driver rejects its own data
        info.initialDataSize = 0;
        info.pInitialData = nullptr;
        made = vkCreatePipelineCache(device, &info, nullptr, &cache);
    }
    if (made < 0) return nullptr;
    return std::unique_ptr<PipelineCache>(
        new PipelineCache(device, cache, std::move(file), std::move(read), info.initialDataSize == 0));
}

void PipelineCache::close(bool keeps) noexcept {
    try {
        if (keeps) write();
    } catch (const std::exception&) {
        // Out of memory: nothing is kept, and the next start compiles.
    }
    vkDestroyPipelineCache(device_, std::exchange(cache_, VkPipelineCache{VK_NULL_HANDLE}), nullptr);
}

void PipelineCache::write() const {
    std::size_t size = 0;
    if (vkGetPipelineCacheData(device_, cache_, &size, nullptr) < 0 || size == 0 || size > kMostBytes / 2)
        return;
    std::string data(size, '\0');
    if (vkGetPipelineCacheData(device_, cache_, &size, data.data()) != VK_SUCCESS) return;
    data.resize(size);
    const std::string file = sealedKernels(data);
    if (file == read_) return;
    makeFolder(file_.parent_path());
    if (const Result<void> written = writeTextAtomically(file_, file); !written) {
        log::debug("The compiled kernels are not kept: {}", written.error().message.english());
        return;
    }
    removeOldFiles(file_.parent_path());
}

}  // namespace macula::gpu
