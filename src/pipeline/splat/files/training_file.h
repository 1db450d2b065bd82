// .macula files: a model and everything needed to continue its training exactly (training_state.h).
//
// A chunk file (chunk_file.h) of version kTrainingFileVersion with the chunks of kTrainingChunks;
// docs/model-files.md says what each holds. Chunks of other names are ignored. The pictures are those that it
// was trained with, and reveal as much of a patient as other pictures do; the file holds no name unless the
// caller puts one into the key.
//
// With 12 pictures of 512 x 512 with 8 samples, 64 % of each empty, and 10 000 splats: 13 MB instead of 52,
// written in 0.21 s and read in 0.15 s on one core; the splats alone are read in 2 ms.
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

// A chunk and its stride, the bytes of an element, by which it is packed (chunk_file.h); 0: text, not packed.
struct TrainingChunk {
    std::string_view name;
    std::uint32_t stride;
};
// A test compares the table of docs/model-files.md with this one, and this one with written files.
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

// The chunks that hold the model.
inline constexpr SplatChunkNames kModelChunks{.text = "model", .numbers = "splats"};

// With a path, writes the file whole or not at all. readTraining returns the same state bit for bit. Fails
// with inputNotUsable for a state that is not valid; with outputNotWritable; with outOfMemory.
Result<void> writeTraining(const std::filesystem::path& path, const TrainingState& state);
Result<void> writeTraining(std::ostream& stream, const TrainingState& state);

// Chunks of other names in the same file.
struct FurtherChunks {
    std::span<const Chunk> early;  // after the model and the key: can be read without the rest
    std::span<const Chunk> late;   // at the end
};
// The same; `packed` must have packed the pictures of the state.
Result<void> writeTraining(std::ostream& stream, const TrainingState& state, const FurtherChunks& further,
                           const PackedPictures& packed);

// Returns a valid state. Fails with inputNotUsable when the file is missing, of another kind, damaged or cut
// off, or of another version of the format or of the trainer: the error names both versions. readModel can
// still read the model of another trainer. Allocates no more memory than a file of that size can fill.
Result<TrainingState> readTraining(const std::filesystem::path& path);
Result<TrainingState> readTraining(std::istream& stream, std::uint64_t size);
// The same from a file whose heads have all been read.
Result<TrainingState> readTraining(ChunkFile& file);

// The part that can be read whatever the trainer's version.
struct TrainingHead {
    std::uint32_t trainerVersion = 0;
    std::uint64_t steps = 0;
    std::string key;
};
Result<TrainingHead> readTrainingHead(ChunkFile& file);

// Whether a file is .macula, by its first 8 bytes.
bool looksLikeTraining(std::string_view begin);
// Reads only the splats, whatever the trainer's version. See readModel.
Result<ModelFile> readTrainedModel(std::istream& stream, std::uint64_t size, BadSplats bad);

}  // namespace macula::splat
