// Tile lists (tile_lists.h) in buffers that kernels read. The buffers grow with the picture and with the
// pairs.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "base/result.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/splat/draw/tile_lists.h"

namespace macula::splat {

// outOfMemory: the splats are too large and too many.
Error tooManyPairs();

// How large to make a buffer: larger than requested, because later requests grow, or exactly as large, if the
// caller has added room.
enum class Room { toGrow, exact };

// Gives `texels` room for `elements`: keeps the buffer, or makes a larger one.
Result<void> makeRoom(std::optional<gpu::TexelBuffer>& texels, const std::shared_ptr<gpu::Device>& device,
                      const char* label, VkFormat format, std::uint64_t elements, VkBufferUsageFlags usage,
                      Room room = Room::toGrow);

// The usage of a texel buffer that kernels both write and read.
inline constexpr VkBufferUsageFlags kReadAndWritten =
    VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;

struct TileBuffers {
    // Where the lists are made. The device needs storage buffers to write its lists, and these are more
    // limited in size.
    enum class Maker { host, device };
    Maker maker = Maker::host;
    std::shared_ptr<gpu::Device> device;
    std::optional<gpu::TexelBuffer> ranges;   // for each tile: first entry, and one after the last
    std::optional<gpu::TexelBuffer> entries;  // for each tile, front to back: splat, number of the pair
    gpu::TexelBuffer pairs;                   // for each splat: first pair, and how many

    static Result<TileBuffers> create(const std::shared_ptr<gpu::Device>& device, Maker maker,
                                      std::uint32_t splats);
    // Makes room for `tiles` tiles and `pairCount` pairs; a buffer that is replaced by a larger one loses its
    // content. Fails with tooManyPairs (outOfMemory).
    Result<void> makeRoomFor(std::uint64_t tiles, std::uint64_t pairCount);
    // `withPairs`: also uploads `pairs`, which recordBackward needs.
    Result<void> upload(const TileLists& lists, bool withPairs);
};

}  // namespace macula::splat
