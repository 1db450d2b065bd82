// .macula files: a model and all that its training needs to go on exactly (training_state.h).
//
// A chunk_file.h of version kTrainingFileVersion with the chunks of kTrainingChunks; docs/model-files.md says
// what each holds. Chunks of other names are left alone. The pictures are what it was trained with and tell
// as much of a patient as others do; no name is in it unless the caller puts one into the key.
//
// Of 12 pictures of 512 x 512 with 8 samples, 64 % of each empty, and 10 000 splats: 13 MB of 52, written in
// 0.21 s and read in 0.15 s of one core; its splats alone in 2 ms.
#pragma once

#include <array>
#include <filesystem>
#include <istream>
#include <ostream>
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"
#include "pipeline/splat/files/chunk_file.h"
#include "pipeline/splat/files/model_file.h"
#include "pipeline/splat/files/packed_pictures.h"
#include "pipeline/splat/files/splat_chunks.h"
#include "pipeline/splat/train/training_state.h"

namespace macula::splat {

inline constexpr std::uint32_t kTrainingFileVersion = 1;

// Bytes of an element, by which a chunk is packed (chunk_file.h); 0: text, not packed.
struct TrainingChunk {
    std::string_view name;
    std::uint32_t stride;
};
// A test holds the table of docs/model-files.md to this one, and this one to what is written.
inline constexpr std::array<TrainingChunk, 10> kTrainingChunks{{{"model", 0},
                                                                {"splats", 4},
                                                                {"training", 0},
                                                                {"key", 0},
                                                                {"first", 4},
                                                                {"second", 4},
                                                                {"steps", 4},
                                                                {"stats", 16},
                                                                {"views", 168},
                                                                {"pixels", 16}}};

// Those of them that hold the model.
inline constexpr SplatChunkNames kModelChunks{.text = "model", .numbers = "splats"};

// Writes the file whole or not at all. Bit for bit what readTraining gives. inputNotUsable for a state that
// is not valid; outputNotWritable; outOfMemory.
Result<void> writeTraining(const std::filesystem::path& path, const TrainingState& state);
Result<void> writeTraining(std::ostream& stream, const TrainingState& state);

// Chunks of other names in the same file.
struct FurtherChunks {
    std::span<const Chunk> early;  // behind the model and the key: found without reading on
    std::span<const Chunk> late;   // at the end
};
// Likewise; the pictures of the state are among those that `packed` has packed.
Result<void> writeTraining(std::ostream& stream, const TrainingState& state, const FurtherChunks& further,
                           const PackedPictures& packed);

// The state is valid. Fails with inputNotUsable when the file is missing, of another kind, damaged or cut
// off, or of another version, of the format or of the trainer: the sentence names both. Of another trainer
// the model can still be read, by readModel. No more memory is asked for than a file of that size can fill.
Result<TrainingState> readTraining(const std::filesystem::path& path);
Result<TrainingState> readTraining(std::istream& stream, std::uint64_t size);
// Likewise from a file of which all heads were read.
Result<TrainingState> readTraining(ChunkFile& file);

// What can be told of any trainer's state.
struct TrainingHead {
    std::uint32_t trainerVersion = 0;
    std::uint64_t steps = 0;
    std::string key;
};
Result<TrainingHead> readTrainingHead(ChunkFile& file);

// Whether a file is .macula, by its first 8 bytes.
bool looksLikeTraining(std::string_view begin);
// Only the splats, whatever trainer they are of. See readModel.
Result<ModelFile> readTrainedModel(std::istream& stream, std::uint64_t size, BadSplats bad);

}  // namespace macula::splat
