// Lists of tiles (tile_lists.h) as the kernels read them. They grow with the picture and with the pairs.
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

// How large one is made: larger than asked for, because more will be; or not, where what was asked for is so
// already.
enum class Room { toGrow, exact };

// One that has room for `elements`: the same, or a larger one.
Result<void> makeRoom(std::optional<gpu::TexelBuffer>& texels, const std::shared_ptr<gpu::Device>& device,
                      const char* label, VkFormat format, std::uint64_t elements, VkBufferUsageFlags usage,
                      Room room = Room::toGrow);

// What a kernel may write or read.
inline constexpr VkBufferUsageFlags kReadAndWritten =
    VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;

struct TileBuffers {
    // Of lists made where? The device's are storage buffers too, and these are more limited in size.
    enum class Maker { host, device };
    Maker maker = Maker::host;
    std::shared_ptr<gpu::Device> device;
    std::optional<gpu::TexelBuffer> ranges;   // by tile: first entry, and one after the last
    std::optional<gpu::TexelBuffer> entries;  // by tile, front to back: splat, number of the pair
    gpu::TexelBuffer pairs;                   // by splat: first pair, and how many

    static Result<TileBuffers> create(const std::shared_ptr<gpu::Device>& device, Maker maker,
                                      std::uint32_t splats);
    // Room for as many; what was in larger ones is lost. outOfMemory as tooManyPairs.
    Result<void> makeRoomFor(std::uint64_t tiles, std::uint64_t pairCount);
    // `withPairs`: for recordBackward.
    Result<void> upload(const TileLists& lists, bool withPairs);
};

}  // namespace macula::splat
