// Splats as two chunks of a .macula file: text that says what they are (model_notes.h), and their numbers.
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

// To write; holds what its chunks point to.
class SplatChunks {
  public:
    // The splats are valid.
    explicit SplatChunks(const Splats& splats);

    std::array<Chunk, 2> named(const SplatChunkNames& names) const;
    // Whether both would read back to the same bits.
    bool isSameAs(const SplatChunks& other) const;

  private:
    std::string text_;
    std::vector<float> numbers_;
};

// Fails with inputNotUsable when the chunks are missing or damaged, or do not belong together. The splats are
// not validated.
Result<Splats> readSplats(ChunkFile& file, const SplatChunkNames& names);

}  // namespace macula::splat
