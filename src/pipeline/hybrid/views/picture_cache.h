// Pictures that took long to make, kept as files.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"

namespace macula::hybrid {

struct KeptPicture {
    glm::ivec2 sizePx{0};         // columns, rows; 1 to trace::kMaxPictureSide each
    std::vector<glm::vec4> rgba;  // linear, premultiplied; row 0 on top
};

// A folder with a file for each picture, KEY.rgba: a few lines of text and then the pixels, four 32-bit
// floats each, little-endian. Keys are 64 hexadecimal digits (traced_scene.h), so that no name says whose
// picture it is; the pictures themselves show a patient, and the folder is to be kept like one.
class PictureCache {
  public:
    // Without a folder nothing is kept.
    explicit PictureCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

    // Makes the folder if it is not there. Fails with outputNotWritable.
    Result<void> prepare() const;

    // Nothing when it is not there, or is damaged: truncated, changed, of another key.
    std::optional<KeptPicture> find(const std::string& key) const;

    // Writes the file whole or not at all. Fails with outputNotWritable.
    Result<void> keep(const std::string& key, const KeptPicture& picture) const;

  private:
    std::filesystem::path fileOf(const std::string& key) const;

    std::filesystem::path folder_;
};

}  // namespace macula::hybrid
