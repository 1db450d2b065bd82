#include "scene/segments/segments_to_draw.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "scene/segments/segment_mask.h"
#include "study/segmentation/loaded_segmentation.h"

namespace macula::scene {

namespace {

bool isSameLabel(const std::string& a, const std::string& b) {
    return std::ranges::equal(
        a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

// Returns whether any segment has the label.
bool chooseByLabel(const std::vector<study::FoundSegmentation>& found, const SegmentRequest& request,
                   std::vector<SegmentationSettings>& choices) {
    bool isThere = false;
    for (const study::FoundSegmentation& each : found) {
        if (!each.canBeShown()) continue;
        for (const Segment& segment : each.header.segments) {
            if (!isSameLabel(segment.label, request.label)) continue;
            SegmentationSettings whole = choiceOf(choices, each.digest);
            whole.isShown = true;
            choose(choices, whole);
            SegmentSettings one = choiceOf(whole, segment.number);
            if (request.isColoured) {
                one.isColouredIn3d = true;
            } else {
                one.in3d = request.in3d;
            }
            choose(choices, each.digest, one);
            isThere = true;
        }
    }
    return isThere;
}

Result<std::shared_ptr<const study::LoadedSegmentation>> loadedOf(const SegmentationsThere& there,
                                                                  const study::FoundSegmentation& found,
                                                                  const Volume& voxels, Progress& progress) {
    for (const study::OpenedLabelMap& map : there.labelMaps)
        if (map.found.digest == found.digest) return map.loaded;
    return study::loadSegments(found, voxels, *there.volume->stack, progress);
}

}  // namespace

Result<SegmentRequest> segmentRequestFrom(const std::string& typed) {
    const std::size_t colon = typed.find(':');
    const std::string what = typed.substr(0, colon);
    SegmentRequest request;
    if (colon != std::string::npos) request.label = typed.substr(colon + 1);
    if (what == "hide") request.in3d = In3d::hidden;
    request.isColoured = what == "colour";
    if ((what != "keep" && what != "hide" && !request.isColoured) || request.label.empty())
        return Error{ErrorCode::usage, Text("That does not say what to do with which segment."), typed,
                     Text("Write keep:LABEL, hide:LABEL or colour:LABEL; macula info lists the labels.")};
    return request;
}

Result<SegmentsToDraw> segmentsToDraw(const SegmentationsThere& there,
                                      std::vector<SegmentationSettings> choices,
                                      std::span<const SegmentRequest> requests, const Volume& voxels,
                                      Progress& progress) {
    std::vector<study::FoundSegmentation> all;
    if (there.found != nullptr) {
        MACULA_TRY(all, study::findSegmentations(*there.found, *there.volume, progress));
    }
    for (const study::OpenedLabelMap& map : there.labelMaps) all.push_back(map.found);
    for (const SegmentRequest& request : requests) {
        if (!chooseByLabel(all, request, choices))
            return Error{ErrorCode::usage,
                         Text("No segmentation of this volume has a segment of that label."), request.label,
                         Text("macula info lists the labels.")};
    }
    SegmentsToDraw drawn;
    LoadedSegmentations loaded;
    const std::vector<In3dOf> hidden = in3dOf(choices);
    std::vector<std::string> wanted;  // digests
    for (const In3dOf& one : hidden) wanted.push_back(std::get<0>(one));
    for (const ColouredIn3d& one : colouredIn3dOf(choices)) wanted.push_back(std::get<0>(one));
    const auto isWanted = [&](const std::string& digest) {
        return std::ranges::find(wanted, digest) != wanted.end();
    };
    for (const study::FoundSegmentation& each : all) {
        if (!each.canBeShown() || !isWanted(each.digest)) continue;
        MACULA_TRY(auto segments, loadedOf(there, each, voxels, progress));
        for (const Text& note : segments->notes) drawn.notes.push_back(Text("Segmentation: {}", note));
        loaded.push_back(std::move(segments));
    }
    const bool isMissing = std::ranges::any_of(wanted, [&](const std::string& digest) {
        return std::ranges::none_of(loaded, [&](const auto& l) { return l->digest == digest; });
    });
    if (isMissing)
        drawn.notes.push_back(
            Text("A segmentation of the view is not in the folder, and nothing of it is kept, hidden or "
                 "coloured."));
    MACULA_TRY(drawn.mask, segmentMask(choices, loaded, voxels, progress));
    MACULA_TRY(drawn.tints, segmentTints(choices, loaded, voxels, progress));
    if (!hidden.empty() && !drawn.mask)
        drawn.notes.push_back(Text("No voxel of these segments lies in the volume; all of it is shown."));
    return drawn;
}

}  // namespace macula::scene
