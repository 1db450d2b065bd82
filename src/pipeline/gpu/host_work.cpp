#include "pipeline/gpu/host_work.h"

#include <array>
#include <cstring>
#include <new>

#include "pipeline/gpu/vulkan_error.h"

namespace macula::gpu {

Result<void> HostWork::run(const Complete& complete, const std::string& label) {
    for (HostStep& step : steps_) {
        MACULA_TRY_VOID(complete(step.before, step.isEmpty));
        if (!step.groups.empty()) {
            std::array<std::uint32_t, 3> groups{};
            std::memcpy(groups.data(), step.groups.data(), sizeof(groups));
            step.dispatch.setGroups(groups);
        }
        try {
            step.kernel(step.dispatch);
        } catch (const std::bad_alloc&) {
            return vulkanError(VK_ERROR_OUT_OF_HOST_MEMORY, Text("run \"{}\"", label));
        }
    }
    return {};
}

void HostWork::giveBack(const std::function<void(const CommandPool::Commands&)>& give) const {
    for (const HostStep& step : steps_) give(step.before);
}

}  // namespace macula::gpu
