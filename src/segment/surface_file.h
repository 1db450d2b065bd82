// Surfaces in files: STL (.stl) and glTF (.glb), both binary.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "base/result.h"
#include "segment/surface.h"

namespace macula::segment {

enum class SurfaceFormat { stl, glb };
// By the extension, in upper or lower case; nothing for others.
std::optional<SurfaceFormat> surfaceFormatOf(const std::filesystem::path& path);

// The vertices in both are in patient LPS mm. STL names no unit; its header says so in words. glTF counts in
// metres, with Y upwards: its one node has the matrix that takes the patient there (left is +X, the head +Y,
// the front +Z), and `extras` name frame and unit. The colour, sRGB, is that of the material in glTF.
// Nothing of a patient, and no label, is written. The file is written whole or not at all, in place of one
// that is there. Errors: usage for another extension; outputNotWritable; outOfMemory.
Result<void> writeSurface(const std::filesystem::path& path, const TriangleMesh& mesh,
                          const std::array<std::uint8_t, 3>& rgb);

}  // namespace macula::segment
