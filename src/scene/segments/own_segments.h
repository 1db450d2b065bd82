// Segments that a person makes here: one segmentation of the open volume, with as many segments as wanted.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/label_map.h"
#include "base/result.h"
#include "base/volume.h"
#include "base/voxel_set.h"
#include "scene/segments/segmentation_settings.h"
#include "study/segmentation/found_segmentation.h"
#include "study/segmentation/loaded_segmentation.h"

namespace macula::scene {

struct OwnSegment {
    Segment segment;                         // its number is from 1, and unique
    std::shared_ptr<const VoxelSet> voxels;  // in the grid of the volume; not null, may be empty
};

inline constexpr std::size_t kMostOwnSegments = 1000;

// A revision of the segmentation: each change makes another one, with a digest of its own, so that the state
// of a study names it and an undo finds it again. `digest` empty: a new one by chance, 64 digits. Volume and
// middle of each segment are counted from its voxels.
std::shared_ptr<const study::LoadedSegmentation> ownRevision(std::vector<OwnSegment> segments,
                                                             const Volume& volume, std::string digest = {});
std::vector<OwnSegment> segmentsOf(const study::LoadedSegmentation& revision);
// As if it were found in the folder; it has no file.
study::FoundSegmentation foundOwn(const study::LoadedSegmentation& revision, std::string title);

// Puts a revision in the place of the one before: it is shown, and segments keep how they are shown. Each has
// a colour of its own in `choices`, so that the choice also stays there while the segmentation is hidden.
void chooseRevision(std::vector<SegmentationSettings>& choices, const std::string& before,
                    const study::LoadedSegmentation& next);

// The segments as one map of numbers on the grid of the volume; where some overlap, the last one counts, and
// `overlapping` is the number of such voxels. May throw std::bad_alloc.
struct FlatSegments {
    LabelMap map;
    std::size_t overlapping = 0;
};
Result<FlatSegments> flattened(std::span<const OwnSegment> segments, const Volume& volume);

// The segments of a map of numbers that another program made, by number; they are called "Label 3", and have
// no colour. Errors: inputNotUsable for another grid than that of `volume` (more than a hundredth of a voxel
// off at a corner), for values that are no whole numbers from 0 to 65535, for more than kMostOwnSegments of
// them, and for none; outOfMemory.
Result<std::vector<OwnSegment>> segmentsOfLabels(const Volume& labels, const Volume& volume);

}  // namespace macula::scene
