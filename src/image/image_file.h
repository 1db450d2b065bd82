// Picture files: Radiance HDR, OpenEXR and PNG, with OpenImageIO.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "image/image.h"

namespace macula::image {

// How a picture was made, stored in PNG text chunks or EXR attributes. The caller ensures that it holds no
// patient data.
using Metadata = std::vector<std::pair<std::string, std::string>>;

inline constexpr int kMaxEdge = 16384;
inline constexpr std::uint64_t kMaxBytes = std::uint64_t{4} << 30;  // of decoded pixels

// The content determines the format, not the name. Fails with inputNotUsable when the file is missing,
// damaged, truncated, of another format, or larger than kMaxEdge on a side. NaN, infinite and negative values
// are kept: see countFaults.
Result<Image> readImage(const std::filesystem::path& path);

// Counts of values that light cannot have. Readers return such a picture unchanged: the caller decides what
// to do, and reports it.
struct Faults {
    std::size_t notFinite = 0;
    std::size_t negative = 0;

    std::size_t total() const { return notFinite + negative; }
};
Faults countFaults(const Image& image);

// 8-bit RGBA, display-encoded (sRGB), alpha straight; width * height * 4 bytes, row 0 on top. The file is
// written whole or not at all.
Result<void> writePng(const std::filesystem::path& path, int width, int height,
                      std::span<const std::uint8_t> rgba, const Metadata& metadata = {});

// Linear premultiplied RGBA as 32-bit floats, and `depthMm` as channel Z unless it is empty. The file is
// written whole or not at all.
Result<void> writeExr(const std::filesystem::path& path, int width, int height, std::span<const float> rgba,
                      std::span<const float> depthMm = {}, const Metadata& metadata = {});

// The metadata of a PNG or EXR whose keys are among `keys`, in file order.
Result<Metadata> readMetadata(const std::filesystem::path& path, std::span<const std::string> keys);

}  // namespace macula::image
