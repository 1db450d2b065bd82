#include "evaluate/shown_picture.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/srgb.h"
#include "image/image_file.h"
#include "pipeline/gpu/transfer.h"
#include "scene/lights/light_meter.h"

namespace macula::evaluate {

namespace {

double halfTangent(double fieldDeg) {
    return std::tan(0.5 * glm::radians(fieldDeg));
}

struct Neighbours {
    int low = 0;
    int high = 0;
    float share = 0.0f;  // weight of `high`
};

Neighbours neighboursOf(int pixel, int count, int from) {
    const double place = (pixel + 0.5) * double(from) / double(count) - 0.5;
    const double inside = std::clamp(place, 0.0, double(from - 1));
    const int low = static_cast<int>(inside);
    return {low, std::min(low + 1, from - 1), static_cast<float>(inside - double(low))};
}

}  // namespace

image::Image imageOf(std::span<const std::uint8_t> rgba, const glm::ivec2& sizePx) {
    MACULA_CHECK_EQ(rgba.size(), 4 * std::size_t(sizePx.x) * std::size_t(sizePx.y));
    image::Image image{.width = sizePx.x,
                       .height = sizePx.y,
                       .channels = 3,
                       .encoding = image::Encoding::display,
                       .pixels = {}};
    image.pixels.reserve(rgba.size() / 4 * 3);
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        for (std::size_t c = 0; c < 3; ++c) image.pixels.push_back(static_cast<float>(rgba[i + c]) / 255.0f);
    }
    return image;
}

std::vector<double> luminancesOf(const image::Image& shown) {
    MACULA_CHECK(shown.encoding == image::Encoding::display && shown.channels == 3);
    std::vector<double> luminances(shown.pixels.size() / 3);
    for (std::size_t i = 0; i < luminances.size(); ++i) {
        const float* const rgb = shown.pixels.data() + 3 * i;
        luminances[i] = scene::brightnessOf({decodedSrgb(rgb[0]), decodedSrgb(rgb[1]), decodedSrgb(rgb[2])});
    }
    return luminances;
}

image::Image scaledTo(const image::Image& picture, const glm::ivec2& sizePx) {
    MACULA_CHECK(picture.width > 0 && picture.height > 0);
    image::Image scaled{.width = sizePx.x,
                        .height = sizePx.y,
                        .channels = picture.channels,
                        .encoding = picture.encoding,
                        .pixels = {}};
    scaled.pixels.reserve(std::size_t(sizePx.x) * std::size_t(sizePx.y) * std::size_t(picture.channels));
    const auto at = [&](int x, int y, int channel) {
        return picture.pixels[(std::size_t(y) * std::size_t(picture.width) + std::size_t(x)) *
                                  std::size_t(picture.channels) +
                              std::size_t(channel)];
    };
    for (int y = 0; y < sizePx.y; ++y) {
        const Neighbours row = neighboursOf(y, sizePx.y, picture.height);
        for (int x = 0; x < sizePx.x; ++x) {
            const Neighbours column = neighboursOf(x, sizePx.x, picture.width);
            for (int c = 0; c < picture.channels; ++c) {
                const float above =
                    glm::mix(at(column.low, row.low, c), at(column.high, row.low, c), column.share);
                const float below =
                    glm::mix(at(column.low, row.high, c), at(column.high, row.high, c), column.share);
                scaled.pixels.push_back(glm::mix(above, below, row.share));
            }
        }
    }
    return scaled;
}

Result<void> writePng(const std::filesystem::path& path, const image::Image& picture) {
    std::vector<std::uint8_t> rgba;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        rgba.push_back(static_cast<std::uint8_t>(std::lround(picture.pixels[i] * 255.0f)));
        if (i % 3 == 2) rgba.push_back(255);
    }
    return image::writePng(path, picture.width, picture.height, rgba);
}

Result<std::vector<float>> foveaWeightsOf(const hybrid::Frame& frame, const glm::ivec2& sizePx) {
    if (frame.foveaWeights == nullptr) return std::vector<float>();
    MACULA_TRY(std::vector<float> weights, gpu::read<float>(*frame.foveaWeights));
    weights.resize(std::size_t(sizePx.x) * std::size_t(sizePx.y));
    return weights;
}

int foveaSidePx(const glm::ivec2& sizePx, double verticalFovDeg, double fieldDeg) {
    const double share = halfTangent(fieldDeg) / halfTangent(verticalFovDeg);
    return std::max(static_cast<int>(std::lround(sizePx.y * share)), 1);
}

}  // namespace macula::evaluate
