#include "scene/segments/segments_to_file.h"

#include <algorithm>
#include <exception>

#include "base/exceptions.h"
#include "formats/volume_file.h"
#include "segment/surface.h"
#include "segment/surface_file.h"

namespace macula::scene {

namespace {

Result<std::vector<Text>> saveSurface(const std::filesystem::path& path, const SegmentsToSave& what,
                                      Progress& progress) {
    if (!what.surfaceOf)
        return Error{ErrorCode::usage,
                     Text("No segment is chosen whose surface could be saved."),
                     {},
                     Text("Select one in the list.")};
    MACULA_TRY(const segment::TriangleMesh mesh,
               segment::surfaceOf(*what.surfaceOf, what.volume->worldFromVoxel(), kSurfacePasses, progress));
    MACULA_TRY_VOID(segment::writeSurface(path, mesh, what.rgb));
    std::vector<Text> notes{
        Text("{} triangles, smoothed; patient coordinates (LPS) in mm.", mesh.triangles.size())};
    if (!what.volume->provenance().isCalibrated)
        notes.push_back(Text("Its size is an estimate: the size of a pixel is not calibrated."));
    return notes;
}

}  // namespace

Result<std::vector<Text>> saveSegments(const std::filesystem::path& path, const SegmentsToSave& what,
                                       Progress& progress) try {
    if (segment::surfaceFormatOf(path)) return saveSurface(path, what, progress);
    if (std::ranges::all_of(what.segments, [](const OwnSegment& each) { return each.voxels->isEmpty(); }))
        return Error{ErrorCode::usage,
                     Text("No voxel of this volume belongs to a segment."),
                     {},
                     Text("Draw one first.")};
    MACULA_TRY(const FlatSegments flat, flattened(what.segments, *what.volume));
    MACULA_TRY_VOID(formats::writeVolumeFile(flat.map, path, progress));
    std::vector<Text> notes{Text("The file has the numbers of the segments, not their names.")};
    if (flat.overlapping > 0)
        notes.push_back(
            Text("{} voxels are in several segments; the file has them in the last one.", flat.overlapping));
    return notes;
} catch (const std::exception& thrown) {
    return errorOf(thrown, Text("write the segments"));
}

}  // namespace macula::scene
