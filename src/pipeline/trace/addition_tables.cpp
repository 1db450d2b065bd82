#include "pipeline/trace/addition_tables.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "pipeline/trace/scene_texels.h"

namespace macula::trace {

Result<void> AdditionTables::makeNothings(const std::shared_ptr<gpu::Device>& device) {
    const std::uint32_t noWord = 0;
    const std::uint16_t noEntry = 0;
    const glm::uvec4 noBlock(0);
    MACULA_TRY(noWords_,
               uploadedTexels<std::uint32_t>(device, "no words", VK_FORMAT_R32_UINT, std::span(&noWord, 1)));
    MACULA_TRY(noEntries_, uploadedTexels<std::uint16_t>(device, "no entries", VK_FORMAT_R16_UINT,
                                                         std::span(&noEntry, 1)));
    MACULA_TRY(noBlocks_, uploadedTexels<glm::uvec4>(device, "no blocks", VK_FORMAT_R32G32B32A32_UINT,
                                                     std::span(&noBlock, 1)));
    return {};
}

Result<void> AdditionTables::make(const std::shared_ptr<gpu::Device>& device, const Additions& additions) {
    if (!noBlocks_) MACULA_TRY_VOID(makeNothings(device));
    if (!table_) {
        std::vector<glm::vec4> table = additionTable(additions);
        if (table.empty()) table.emplace_back(0.0f);
        MACULA_TRY(table_,
                   uploadedTexels<glm::vec4>(device, "additions", VK_FORMAT_R32G32B32A32_SFLOAT, table));
    }
    if (!tints_ && additions.tints) {
        const std::vector<std::uint8_t>& voxels = additions.tints->box->voxels;
        static_assert(std::endian::native == std::endian::little);  // the first voxel is in the lowest bits
        std::vector<std::uint32_t> words((voxels.size() + 3) / 4, 0);
        std::memcpy(words.data(), voxels.data(), voxels.size());
        MACULA_TRY(tints_, uploadedTexels<std::uint32_t>(device, "segments", VK_FORMAT_R32_UINT, words));
    }
    return {};
}

void AdditionTables::forget() {
    table_.reset();
    tints_.reset();
}

void AdditionTables::forgetFor(const Additions& next, const Additions& before) {
    const bool sameTints = next.tints && before.tints && next.tints->box == before.tints->box;
    if (!sameTints) tints_.reset();
    table_.reset();
}

}  // namespace macula::trace
