// Whether decoded images can be what they say, by their bits and by their neighbours.
#pragma once

#include <span>
#include <vector>

#include "dicom/pixels/frame_decoder.h"
#include "dicom/stack/messages.h"

namespace macula::dicom {

// Looks at the frames of the stack that are `usable`, takes the mark from those that are to be left out, and
// returns what is to be told:
//   - values that need more bits than an image says, where most images say more, or few are so;
//   - pixels of a few images that are certainly read wrongly (odd_slices.h);
//   - what is as odd and stays: such pixels of many images, images unlike their neighbours, steps of the
//   rescale.
std::vector<Message> checkImages(const Stack& stack, std::span<const SliceIntensity> intensities,
                                 const FrameDecoder& decoder, const SliceSamples& samples,
                                 std::vector<bool>& usable);

}  // namespace macula::dicom
