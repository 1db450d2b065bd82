// The cameras that `macula splat-render` draws with.
//
// There are two kinds of file: Macula's own, with one camera (camera_file.h), and the cameras.json that
// trainers in the manner of 3DGS (Kerbl et al. 2023) write next to their models, a list of
//   { "id": 0, "img_name": "DSC08116.JPG", "width": 5187, "height": 3361,
//     "position": [x, y, z], "rotation": [[a, b, c], [d, e, f], [g, h, i]], "fy": 4649.5, "fx": 4627.3 }
// where `position` is the centre of the camera in the coordinates of the model, and `rotation` is
// worldFromCamera row by row, for camera axes x right, y down, z forward (COLMAP): a point p of the camera is
// rotation * p + position in the world, and the columns (a, d, g), (b, e, h), (c, f, i) are the directions
// right, down and forward. (The code that writes it calls the matrix W2C, yet it is the inverse of that.)
// Focal lengths are in pixels of width x height. The principal point is the middle of the picture unless "cx"
// and "cy" give it, which a few trainers add. The reader ignores `id` and unknown keys.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "pipeline/splat/draw/raster_view.h"

namespace macula::scene {

struct SplatCamera {
    std::string name;        // from the file; any text
    splat::RasterView view;  // eyeMm is relative to the origin of the world, not of a model
};

// At a `size` other than its own, a camera keeps its vertical field of view and its pixel aspect; if the
// shape is the same to within a pixel, also its horizontal field of view. An unusable camera is an
// inputNotUsable error that names it.

// The size for a camera that has none of its own.
inline constexpr glm::ivec2 kDefaultCameraSize{768, 768};

// Reads Macula's own file; 768 x 768 without a size. The name is the file's, without its extension.
Result<SplatCamera> readSplatCamera(const std::filesystem::path& path, std::optional<glm::ivec2> size);

// Reads a cameras.json of at least one camera.
Result<std::vector<SplatCamera>> readSplatCameras(const std::filesystem::path& path,
                                                  std::optional<glm::ivec2> size);

// The cameras of the cameras.json `list`, or, if that is empty, one camera from each of `files`.
Result<std::vector<SplatCamera>> readSplatCameras(const std::filesystem::path& list,
                                                  std::span<const std::string> files,
                                                  std::optional<glm::ivec2> size);

}  // namespace macula::scene
