// Picture files: .png with display values, .exr with linear radiance and depth.
#pragma once

#include <filesystem>

#include "base/result.h"
#include "image/image_file.h"
#include "pictures/drawn_picture.h"

namespace macula::pictures {

// usage for an extension other than .png or .exr, in any case.
Result<void> checkPictureName(const std::filesystem::path& path);
bool isExr(const std::filesystem::path& path);
bool isDicom(const std::filesystem::path& path);  // .dcm

// Writes the file whole or not at all: a linear picture as EXR with depth in channel Z, any other as PNG,
// whatever the extension.
Result<void> writePicture(const std::filesystem::path& path, const DrawnPicture& picture,
                          const glm::ivec2& sizePx, const image::Metadata& metadata);

}  // namespace macula::pictures
