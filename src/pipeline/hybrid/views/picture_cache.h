// Keeps pictures that took long to make as files.
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
// floats each, little-endian. Keys are 64 hexadecimal digits (traced_scene.h), so that file names identify
// nobody; the pictures themselves show a patient, and the folder must be protected as patient data.
class PictureCache {
  public:
    // With an empty path nothing is kept.
    explicit PictureCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

    // Makes the folder if it is missing. Fails with outputNotWritable.
    Result<void> prepare() const;

    // Nothing if the file is missing or damaged: truncated, changed, or of another key.
    std::optional<KeptPicture> find(const std::string& key) const;

    // Writes the file whole or not at all. Fails with outputNotWritable.
    Result<void> keep(const std::string& key, const KeptPicture& picture) const;

  private:
    std::filesystem::path fileOf(const std::string& key) const;

    std::filesystem::path folder_;
};

}  // namespace macula::hybrid
