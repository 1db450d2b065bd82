// Segments that a picture leaves out, shows alone or colours, for programs without a window.
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
#include "scene/segments/segmentation_settings.h"
#include "study/segmentation/found_segmentation.h"
#include "study/segmentation/label_map.h"

namespace macula::scene {

struct SegmentRequest {
    In3d in3d = In3d::alone;
    bool isColoured = false;  // `in3d` is ignored then: the segment stays, in its colour
    std::string label;
};

// "keep:Liver" draws nothing else; also "hide:Liver" and "colour:Liver". Error: usage for anything else.
Result<SegmentRequest> segmentRequestFrom(const std::string& typed);

struct SegmentsToDraw {
    std::optional<Mask> mask;           // nothing: all is shown
    std::optional<SegmentTints> tints;  // nothing: none is coloured
    std::vector<Text> notes;            // sentences, without patient data
};

// The segmentations of a volume.
struct SegmentationsThere {
    const study::FoundVolumes* found = nullptr;         // null: the volume is of no folder
    const study::FoundVolume* volume = nullptr;         // among `found`
    std::vector<study::OpenedLabelMap> labelMaps = {};  // on the voxels of the volume
};

// Adds `requests` to the choices of a view. A request applies to all segments with its label, in upper or
// lower case, of the volume's segmentations. Errors: usage if there is no such segment; those of
// loadSegments.
Result<SegmentsToDraw> segmentsToDraw(const SegmentationsThere& there,
                                      std::vector<SegmentationSettings> choices,
                                      std::span<const SegmentRequest> requests, const Volume& voxels,
                                      Progress& progress);

}  // namespace macula::scene
