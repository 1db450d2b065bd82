// Images that cannot be what they say: one among many whose pixels cannot be read, or
// whose rescale or position is missing or absurd.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dicom/stack/stack.h"

namespace macula::dicom {

struct OddImages {
    std::vector<Frame> frames;
    StackLabel label;
    Message message;  // names the images by their numbers
};

// Takes them out of `frames`, which agree in everything hard (split_rules.h), so that each is a gap in the
// volume of the others:
//   - values in another unit than those of most, which are never in one volume with these;
//   - pixels in a transfer syntax or of bits that cannot be read, where most can be;
//   - rescale slope or intercept missing or unusable where others have both, unless 1 and 0 are what all
//   others have; of the other sign than most; or of a size that no value can have (PS3.3 C.11.1);
//   - a position out of all proportion to the others', if these then are a volume (PS3.3 C.7.6.2).
std::vector<OddImages> takeOddImages(std::vector<Frame>& frames, const std::string& modality);

// Tells of the images without a position in a series in which nearly all have one.
std::optional<Message> imagesWithoutPosition(const std::vector<Frame>& frames);

// "3, 5-7, 12": InstanceNumbers, and of multi-frame files the frame after a colon.
std::string describeNumbers(const std::vector<const Frame*>& frames);

}  // namespace macula::dicom
