// Checks whether decoded images agree with their headers, by their bits and by their neighbours.
#pragma once

#include <span>
#include <vector>

#include "dicom/messages/messages.h"
#include "dicom/pixels/frame_decoder.h"

namespace macula::dicom {

// Checks the `usable` frames of the stack, clears the mark of those to leave out, and returns messages about:
//   - values that need more bits than declared, where most images declare more, or few are affected;
//   - pixels of a few images that are certainly wrong as read (odd_slices.h);
//   - faults that stay in the volume: such pixels in many images, images unlike their neighbours, steps of
//     the rescale.
std::vector<Message> checkImages(const Stack& stack, std::span<const SliceIntensity> intensities,
                                 const FrameDecoder& decoder, const SliceSamples& samples,
                                 std::vector<bool>& usable);

}  // namespace macula::dicom
