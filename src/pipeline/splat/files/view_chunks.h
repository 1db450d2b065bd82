// Views as chunks of a .macula file: a chunk with a record of each, and one for the pixels of each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "pipeline/splat/files/chunk_file.h"
#include "pipeline/splat/train/training_state.h"

namespace macula::splat {

// Strides of these chunks.
inline constexpr std::uint32_t kViewRecordBytes = 168;
inline constexpr std::uint32_t kPixelBytes = sizeof(glm::vec4);

inline constexpr std::uint64_t kMostViews = std::uint64_t(1) << 20;

struct ViewChunkNames {
    std::string_view records;
    std::string_view pixels;
};

// A record for each view; docs/model-files.md says of what. They are whole, and not parts of pictures.
std::vector<std::byte> viewRecords(std::span<const TrainingState::View> views);

// Unpacks pixels on all cores. Fails with inputNotUsable when chunks are missing or damaged or there are not
// as many, at most kMostViews, or a picture is not of its view's size; outOfMemory.
Result<std::vector<TrainingState::View>> readViews(ChunkFile& file, const ViewChunkNames& names,
                                                   std::uint64_t count);

}  // namespace macula::splat
