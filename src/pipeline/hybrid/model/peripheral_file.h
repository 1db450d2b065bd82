// A peripheral model in a file, kept between runs: a .macula file (training_file.h) with further chunks.
//
// What can be drawn at once lies first, so that a study that is opened again is shown before the rest, nearly
// all of it pictures, is read. Programs that know only the training read that, and train on without held-out
// pictures. As in any such file nothing but the pictures tells of a patient, unless the key does.
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

// In this order, from the first up to `bestspl` behind the key and before the moments; docs/model-files.md
// says what each holds. A test holds the page to this table, and the table to what is written.
inline constexpr std::array<splat::TrainingChunk, 7> kPeripheralChunks{{{"shown", 0},
                                                                        {"shownspl", 4},
                                                                        {"notes", 0},
                                                                        {"best", 0},
                                                                        {"bestspl", 4},
                                                                        {"heldout", 168},
                                                                        {"heldpix", 16}}};

// Writes all of it. Pictures that `packed` has from the last time are not packed again; it keeps those of
// this state, and no others. The same state gives the same bytes. inputNotUsable for a state that is not
// valid; outputNotWritable; outOfMemory.
Result<void> writePeripheral(std::ostream& stream, const PeripheralState& state,
                             splat::PackedPictures& packed);

struct PeripheralFile {
    // Bit for bit what was written. Valid.
    PeripheralState state;
    // A training without any of the chunks above, as `macula train` writes: then only `training` is set and
    // valid. Resume goes on with it once `seenMm` is set to what can be seen of its scene; nothing is held
    // out yet, and `gain` is to be measured.
    bool isTrainingOnly = false;
};

// Fails with inputNotUsable when chunks are missing, damaged or cut off, do not belong together, or are of
// another version of the format or of the trainer: the sentence names both. No more memory is asked for than
// a file of that size can fill.
Result<PeripheralFile> readPeripheral(std::istream& stream, std::uint64_t size);

// What was on the screen.
struct DrawableModel {
    std::shared_ptr<const splat::Splats> splats;  // valid; those that were shown
    std::string key;
    std::uint32_t trainerVersion = 0;  // of another one it can be drawn, but not gone on with
    std::uint64_t steps = 0;           // of training
    double gain = 1.0;                 // of PeripheralState
    Box seenMm;
    bool isTrainingOnly = false;  // as above: gain and seenMm are not known
};

// Reads some 1 MB for 10 000 splats, whatever the size of the file, and checks that. What lies behind it is
// not looked at: only readPeripheral tells whether that is whole. Fails likewise, but for another trainer.
Result<DrawableModel> readDrawable(std::istream& stream, std::uint64_t size);

}  // namespace macula::hybrid
