// A peripheral model in a file, kept between runs: a .macula file (training_file.h) with further chunks.
//
// The drawable splats lie first, so that a reopened study is shown before the rest, nearly all of it
// pictures, is read. Programs that know only the training read that part, and continue without held-out
// pictures. As in any .macula file only the pictures contain patient data, unless the key does.
//
//     drawable = readDrawable(stream, size);      // milliseconds: to show, as bright as gain says
//     file = readPeripheral(stream, size);        // a second: PeripheralModel::resume(device, file.state)
#pragma once

#include <array>
#include <cstdint>
#include <istream>
#include <memory>
#include <ostream>
#include <string>

#include "base/frames.h"
#include "base/result.h"
#include "pipeline/hybrid/model/peripheral_state.h"
#include "pipeline/splat/files/packed_pictures.h"
#include "pipeline/splat/files/training_file.h"

namespace macula::hybrid {

// In this order; those up to `bestspl` lie behind the key and before the moments. docs/model-files.md says
// what each holds. A test compares that page with this table, and this table with a written file.
inline constexpr std::array<splat::TrainingChunk, 7> kPeripheralChunks{{{"shown", 0},
                                                                        {"shownspl", 4},
                                                                        {"notes", 0},
                                                                        {"best", 0},
                                                                        {"bestspl", 4},
                                                                        {"heldout", 168},
                                                                        {"heldpix", 16}}};

// Writes the whole state. Does not pack pictures again that `packed` has from the last time; it keeps those
// of this state, and no others. The same state gives the same bytes. Fails with inputNotUsable for an invalid
// state, outputNotWritable and outOfMemory.
Result<void> writePeripheral(std::ostream& stream, const PeripheralState& state,
                             splat::PackedPictures& packed);

struct PeripheralFile {
    // Valid, and bit for bit the state that was written.
    PeripheralState state;
    // A training without any of the chunks above, as `macula train` writes: only `training` is set and valid.
    // resume() accepts the state once `seenMm` is set to the box of visible matter; no pictures are held out
    // yet, and `gain` must be measured.
    bool isTrainingOnly = false;
};

// Fails with inputNotUsable if chunks are missing, damaged or cut off, do not belong together, or come from
// another version of the format or of the trainer: the error names both versions. Allocates no more memory
// than a file of this size can fill.
Result<PeripheralFile> readPeripheral(std::istream& stream, std::uint64_t size);

// What a file can show before all of it is read.
struct DrawableModel {
    std::shared_ptr<const splat::Splats> splats;  // valid; those last shown
    std::string key;
    std::uint32_t trainerVersion = 0;  // with another one it can be drawn, but not trained
    std::uint64_t steps = 0;           // of training
    double gain = 1.0;                 // PeripheralState::gain
    Box seenMm;
    bool isTrainingOnly = false;  // as above: gain and seenMm are unknown
};

// Reads and checks only the first part, some 1 MB for 10 000 splats, whatever the size of the file: only
// readPeripheral tells whether the rest is whole. Fails likewise, but accepts another trainer version.
Result<DrawableModel> readDrawable(std::istream& stream, std::uint64_t size);

}  // namespace macula::hybrid
