// Views as chunks of a .macula file: one chunk with a record for each view, and a chunk of pixels for each.
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

// A record for each view; docs/model-files.md describes it. The views must be whole, not parts of pictures.
std::vector<std::byte> viewRecords(std::span<const TrainingState::View> views);

// Reads `count` views, and unpacks their pixels on all cores. Fails with inputNotUsable when chunks are
// missing or damaged, there are more or fewer views, or more than kMostViews, or a picture is not of its
// view's size; with outOfMemory.
Result<std::vector<TrainingState::View>> readViews(ChunkFile& file, const ViewChunkNames& names,
                                                   std::uint64_t count);

}  // namespace macula::splat
