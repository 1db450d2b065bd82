// Finds images that contradict the others of their series: those whose pixels cannot be read, or whose
// rescale or position is missing or absurd.
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

// Removes odd images from `frames`, which agree in all hard attributes (split_rules.h), so that each leaves a
// gap in the volume of the others:
//   - values in another unit than most have, which never share a volume with these;
//   - pixels in a transfer syntax or of bits that cannot be read, where most can be;
//   - rescale slope or intercept missing or unusable where others have both, unless 1 and 0 are what all
//   others have; of the other sign than most; or of a size that no value can have (PS3.3 C.11.1);
//   - a position far from the others, if these then form a volume (PS3.3 C.7.6.2).
std::vector<OddImages> takeOddImages(std::vector<Frame>& frames, const std::string& modality);

// The message about images without a position in a series in which nearly all have one.
std::optional<Message> imagesWithoutPosition(const std::vector<Frame>& frames);

// "3, 5-7, 12": InstanceNumbers; for multi-frame files with the frame after a colon.
Text describeNumbers(const std::vector<const Frame*>& frames);
// The same for these frames of a stack.
Text describeNumbers(const Stack& stack, const std::vector<std::size_t>& frames);

}  // namespace macula::dicom
