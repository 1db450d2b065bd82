// .macula files: a model and all that its training needs to go on exactly (training_state.h).
//
// A chunk_file.h of version kTrainingFileVersion with these chunks, in which N is the number of splats, K
// that of components for each (splat_components.h), V that of views:
//   model     text, a line each: those of model_notes.h; "splats N"; "degree D"
//   splats    float: component k of splat i at k * N + i, positions relative to the origin
//   training  text, a line each: "trainer T", its version; "steps S"; "optimizer-steps S"; "views V"; and
//             "option NAME VALUE" for each of option_lines.h
//   key       what the caller says the pictures show
//   first     float: the first moments, as splats
//   second    float: the second moments
//   steps     u32 of each splat
//   stats     four float of each splat, SplatStatistics of shaders/shared/splat_frame.h
//   views     for each view the 168 bytes of a ViewRecord (training_file.cpp)
//   pixels    as often as there are views, in their order: premultiplied RGBA in float, row 0 on top
// Chunks of other names are left alone. All but the texts are packed. The pictures are what it was trained
// with and tell as much of a patient as others do; no name is in it unless the caller puts one into the key.
//
// Of 12 pictures of 512 x 512 with 8 samples, 64 % of each empty, and 10 000 splats: 13 MB of 52, written in
// 0.21 s and read in 0.15 s of one core; its splats alone in 2 ms.
#pragma once

#include <filesystem>
#include <istream>
#include <ostream>
#include <string_view>

#include "base/result.h"
#include "pipeline/splat/files/model_file.h"
#include "pipeline/splat/train/training_state.h"

namespace macula::splat {

inline constexpr std::uint32_t kTrainingFileVersion = 1;

// Whole or not at all. Bit for bit what readTraining gives. inputNotUsable for a state that is not valid;
// outputNotWritable; outOfMemory.
Result<void> writeTraining(const std::filesystem::path& path, const TrainingState& state);
Result<void> writeTraining(std::ostream& stream, const TrainingState& state);

// Valid. Fails with inputNotUsable when the file is missing, of another kind, damaged or cut off, or of
// another version, of the format or of the trainer: the sentence names both. Of another trainer the model can
// still be read, by readModel. No more memory is asked for than a file of that size can fill.
Result<TrainingState> readTraining(const std::filesystem::path& path);
Result<TrainingState> readTraining(std::istream& stream, std::uint64_t size);

// By the first 8 bytes.
bool looksLikeTraining(std::string_view begin);
// Only the splats, whatever trainer they are of. See readModel.
Result<ModelFile> readTrainedModel(std::istream& stream, std::uint64_t size, BadSplats bad);

}  // namespace macula::splat
