#include "pipeline/gpu/timed_sections.h"

#include "base/check.h"

namespace macula::gpu {

int TimedSections::begin(VkCommandBuffer commands, std::string_view name) {
    MACULA_CHECK_LT(names_.size(), static_cast<std::size_t>(kMost));
    const auto section = static_cast<std::uint32_t>(names_.size());
    names_.emplace_back(name);
    vkCmdResetQueryPool(commands, queries_, 2 * section, 2);
    vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, queries_, 2 * section);
    return static_cast<int>(section);
}

void TimedSections::end(VkCommandBuffer commands, int section) const {
    vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, queries_,
                         static_cast<std::uint32_t>(2 * section + 1));
}

VkResult TimedSections::read(VkDevice device, std::uint32_t validBits, double periodNs,
                             std::vector<Timing>& timings) const {
    timings.clear();
    if (names_.empty()) return VK_SUCCESS;
    std::vector<std::uint64_t> stamps(2 * names_.size());
    const VkResult result = vkGetQueryPoolResults(
        device, queries_, 0, static_cast<std::uint32_t>(stamps.size()), stamps.size() * sizeof(stamps[0]),
        stamps.data(), sizeof(stamps[0]), VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT);
    if (result < 0) return result;
    const std::uint64_t valid = validBits >= 64 ? ~0ull : (1ull << validBits) - 1;
    for (std::size_t i = 0; i < names_.size(); ++i) {
        const std::uint64_t ticks = (stamps[2 * i + 1] - stamps[2 * i]) & valid;  // the counter may wrap
        timings.push_back({names_[i], static_cast<double>(ticks) * periodNs * 1e-6});
    }
    return VK_SUCCESS;
}

}  // namespace macula::gpu
