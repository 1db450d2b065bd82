// The functions of the plug-in that reads and writes picture files (base/plugin.h). It is a plug-in because
// OpenImageIO depends on some 230 libraries, which take half a second to load.
#pragma once

#include "image/image_file.h"

namespace macula::image {

// The functions of image_file.h.
struct PictureFiles {
    Result<Image> (*readImage)(const std::filesystem::path& path);
    Result<void> (*writePng)(const std::filesystem::path& path, int width, int height,
                             std::span<const std::uint8_t> rgba, const Metadata& metadata);
    Result<void> (*writeExr)(const std::filesystem::path& path, int width, int height,
                             std::span<const float> rgba, std::span<const float> depthMm,
                             const Metadata& metadata);
    Result<Metadata> (*readMetadata)(const std::filesystem::path& path, std::span<const std::string> keys);
};

}  // namespace macula::image

// The plug-in's export. Never null.
extern "C" const macula::image::PictureFiles* maculaPictureFiles();
