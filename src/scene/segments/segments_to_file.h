// Own segments as files for other programs: label maps, and surfaces.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "scene/segments/own_segments.h"

namespace macula::scene {

struct SegmentsToSave {
    std::vector<OwnSegment> segments;           // in a label map, all of them
    std::shared_ptr<const VoxelSet> surfaceOf;  // of one segment; null: none was chosen
    std::array<std::uint8_t, 3> rgb{};          // of that one, sRGB
    std::shared_ptr<const Volume> volume;
};

// The passes of smoothing of a surface that is written.
inline constexpr int kSurfacePasses = 10;

// Decides by the extension: .stl and .glb are surfaces, and .nii.gz, .nrrd and the others of src/formats maps
// of numbers. Returns sentences on what a reader of the file has to know. Errors: usage for a surface of no
// segment, or segments without voxels; those of writing. Throws nothing.
Result<std::vector<Text>> saveSegments(const std::filesystem::path& path, const SegmentsToSave& what,
                                       Progress& progress);

}  // namespace macula::scene
