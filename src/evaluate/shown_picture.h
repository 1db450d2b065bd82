// Displayed frames on the host, for comparisons as a whole and in the middle, where the eye looks.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "base/result.h"
#include "image/image.h"
#include "pipeline/hybrid/frame/hybrid_frame.h"
#include "pipeline/trace/settings.h"

namespace macula::evaluate {

// The colours of RGBA8 over black; row 0 on top.
image::Image imageOf(std::span<const std::uint8_t> rgba, const glm::ivec2& sizePx);

// The luminance (Rec. 709) of each pixel in linear light, row 0 on top. `shown` must have three channels and
// be display-encoded.
std::vector<double> luminancesOf(const image::Image& shown);

// Writes a picture with three channels, display-encoded.
Result<void> writePng(const std::filesystem::path& path, const image::Image& picture);

// The weight of the fovea in each pixel of a frame; empty without a fovea. Waits for the device.
Result<std::vector<float>> foveaWeightsOf(const hybrid::Frame& frame, const glm::ivec2& sizePx);

// The picture at another size: bilinear between pixel centres, with the border repeated beyond them.
image::Image scaledTo(const image::Image& picture, const glm::ivec2& sizePx);

// The side of a picture of the field `fieldDeg`, with as many pixels per degree as the middle of the frame.
int foveaSidePx(const glm::ivec2& sizePx, double verticalFovDeg, double fieldDeg = trace::kFovealFieldDeg);

}  // namespace macula::evaluate
