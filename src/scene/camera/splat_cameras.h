// The cameras that `macula splat-render` draws with.
//
// Two kinds of file. Macula's own, one camera (camera_file.h). And the cameras.json that trainers in the
// manner of 3DGS (Kerbl et al. 2023) write beside their models: a list of
//   { "id": 0, "img_name": "DSC08116.JPG", "width": 5187, "height": 3361,
//     "position": [x, y, z], "rotation": [[a, b, c], [d, e, f], [g, h, i]], "fy": 4649.5, "fx": 4627.3 }
// where `position` is the centre of the camera in the coordinates of the model, and `rotation` is
// worldFromCamera row by row, for camera axes x right, y down, z forward (COLMAP): a point p of the camera is
// rotation * p + position in the world, and the columns (a, d, g), (b, e, h), (c, f, i) are where right, down
// and forward point. (The code that writes it calls the matrix W2C, yet it is the inverse of that.) Focal
// lengths are in pixels of width x height. The principal point is the middle of the picture, unless there are
// "cx" and "cy", which a few trainers add. `id` and keys that are not known are not read.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "pipeline/splat/draw/raster_view.h"

namespace macula::app {

struct SplatCamera {
    std::string name;        // as the file has it; may be anything
    splat::RasterView view;  // eyeMm from the origin of the world, not of a model
};

// In both kinds of file: at a `size` other than its own a camera keeps its vertical field of view and square
// pixels square; where that is the same shape but for a pixel, its horizontal field of view too. What cannot
// be used is inputNotUsable and says which camera it is.

// The size for a camera that has none of its own.
inline constexpr glm::ivec2 kDefaultCameraSize{768, 768};

// Reads Macula's own file; 768 x 768 without a size. Named like the file.
Result<SplatCamera> readSplatCamera(const std::filesystem::path& path, std::optional<glm::ivec2> size);

// A cameras.json, at least one camera.
Result<std::vector<SplatCamera>> readSplatCameras(const std::filesystem::path& path,
                                                  std::optional<glm::ivec2> size);

// The cameras of `list`, a cameras.json; where that is empty one of each of `files`.
Result<std::vector<SplatCamera>> readSplatCameras(const std::filesystem::path& list,
                                                  std::span<const std::string> files,
                                                  std::optional<glm::ivec2> size);

}  // namespace macula::app
