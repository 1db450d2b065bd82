#include "pictures/picture_file.h"

#include <span>

#include "base/parsing.h"

namespace macula::pictures {

namespace fs = std::filesystem;

Result<void> checkPictureName(const fs::path& path) {
    if (isExr(path) || lowerCase(path.extension().string()) == ".png") return {};
    return Error{ErrorCode::usage, Text("The picture must be a .png or .exr file."), path.string(),
                 Text("Give -o a name with one of these endings.")};
}

bool isExr(const fs::path& path) {
    return lowerCase(path.extension().string()) == ".exr";
}

bool isDicom(const fs::path& path) {
    return lowerCase(path.extension().string()) == ".dcm";
}

Result<void> writePicture(const fs::path& path, const DrawnPicture& picture, const glm::ivec2& sizePx,
                          const image::Metadata& metadata) {
    if (!picture.traced) return image::writePng(path, sizePx.x, sizePx.y, picture.rgba, metadata);
    const trace::TracedImage& traced = *picture.traced;
    const std::span<const float> rgba(&traced.radiance.front().x, traced.radiance.size() * 4);
    return image::writeExr(path, sizePx.x, sizePx.y, rgba, traced.depthMm, metadata);
}

}  // namespace macula::pictures
