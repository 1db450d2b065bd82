#include "image/image_file.h"

#include <cmath>

#include "base/plugin.h"
#include "image/picture_files.h"

namespace macula::image {

namespace {

Result<const PictureFiles*> load() {
    MACULA_TRY(void* symbol, symbolOfPlugin("macula-openimageio", "maculaPictureFiles"));
    return reinterpret_cast<decltype(&maculaPictureFiles)>(symbol)();
}

const Result<const PictureFiles*>& pictureFiles() {
    static const Result<const PictureFiles*> files = load();
    return files;
}

}  // namespace

Result<Image> readImage(const std::filesystem::path& path) {
    MACULA_TRY(const PictureFiles* files, pictureFiles());
    return files->readImage(path);
}

Faults countFaults(const Image& image) {
    Faults faults;
    for (const float value : image.pixels) {
        if (!std::isfinite(value)) {
            ++faults.notFinite;
        } else if (value < 0.0f) {
            ++faults.negative;
        }
    }
    return faults;
}

Result<void> writePng(const std::filesystem::path& path, int width, int height,
                      std::span<const std::uint8_t> rgba, const Metadata& metadata) {
    MACULA_TRY(const PictureFiles* files, pictureFiles());
    return files->writePng(path, width, height, rgba, metadata);
}

Result<void> writeExr(const std::filesystem::path& path, int width, int height, std::span<const float> rgba,
                      std::span<const float> depthMm, const Metadata& metadata) {
    MACULA_TRY(const PictureFiles* files, pictureFiles());
    return files->writeExr(path, width, height, rgba, depthMm, metadata);
}

Result<Metadata> readMetadata(const std::filesystem::path& path, std::span<const std::string> keys) {
    MACULA_TRY(const PictureFiles* files, pictureFiles());
    return files->readMetadata(path, keys);
}

}  // namespace macula::image
