// Segments that a picture is drawn without, of alone, or with in colour, for who has no window.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "pipeline/volume/clip.h"
#include "scene/segments/segment_tints.h"
#include "scene/segments/segmentation_choice.h"
#include "study/segmentation/found_segmentation.h"

namespace macula::app {

struct SegmentWish {
    In3d in3d = In3d::alone;
    bool isColoured = false;  // instead: it is there as it is, in its colour
    std::string label;
};

// "keep:Liver", to draw nothing else, "hide:Liver", or "colour:Liver". usage for anything else.
Result<SegmentWish> segmentWishFrom(const std::string& typed);

struct SegmentsToDraw {
    std::optional<Mask> mask;           // nothing: all is shown
    std::optional<SegmentTints> tints;  // nothing: none is coloured
    std::vector<std::string> notes;     // sentences, without patient data
};

// What was chosen in a view, and what is wished besides: of all segments of that label, in whichever case of
// letters, in segmentations of the volume. usage when a wish is for none. Fails as loadSegments.
Result<SegmentsToDraw> segmentsToDraw(const FoundVolumes& found, const FoundVolume& volume,
                                      std::vector<SegmentationChoice> choices,
                                      std::span<const SegmentWish> wishes, const Volume& voxels,
                                      Progress& progress);

}  // namespace macula::app
