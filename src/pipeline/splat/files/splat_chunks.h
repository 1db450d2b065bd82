// Splats as two chunks of a .macula file: a text with their notes (model_notes.h), number and degree, and
// their numbers.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "pipeline/splat/files/chunk_file.h"
#include "pipeline/splat/model/splats.h"

namespace macula::splat {

struct SplatChunkNames {
    std::string_view text;
    std::string_view numbers;
};

// For writing; owns the memory of its chunks.
class SplatChunks {
  public:
    // The splats must be valid.
    explicit SplatChunks(const Splats& splats);

    std::array<Chunk, 2> named(const SplatChunkNames& names) const;
    // Whether both would read back to the same bits.
    bool isSameAs(const SplatChunks& other) const;

  private:
    std::string text_;
    std::vector<float> numbers_;
};

// Fails with inputNotUsable when the chunks are missing or damaged, or do not match. The splats are not
// validated.
Result<Splats> readSplats(ChunkFile& file, const SplatChunkNames& names);

}  // namespace macula::splat
