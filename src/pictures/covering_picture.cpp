#include "pictures/covering_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/check.h"
#include "base/srgb.h"

namespace macula::pictures {

namespace {

std::array<double, 256> lightOfBytes() {
    std::array<double, 256> light{};
    for (std::size_t i = 0; i < light.size(); ++i) light[i] = decodedSrgb(double(i) / 255.0);
    return light;
}

std::uint8_t byteOf(double share) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(share, 0.0, 1.0) * 255.0));
}

}  // namespace

std::vector<std::uint8_t> coveringPicture(std::span<const std::uint8_t> overBlack,
                                          std::span<const std::uint8_t> overWhite) {
    MACULA_CHECK(overBlack.size() == overWhite.size() && overBlack.size() % 4 == 0);
    static const std::array<double, 256> kLight = lightOfBytes();
    std::vector<std::uint8_t> rgba(overBlack.size(), 0);
    for (std::size_t p = 0; p < rgba.size(); p += 4) {
        double coverage = 1.0;
        for (std::size_t c = p; c < p + 3; ++c)
            coverage = std::min(coverage, 1.0 - (kLight[overWhite[c]] - kLight[overBlack[c]]));
        rgba[p + 3] = byteOf(coverage);
        if (rgba[p + 3] == 0) continue;
        for (std::size_t c = p; c < p + 3; ++c)
            rgba[c] = byteOf(encodedSrgb(std::min(kLight[overBlack[c]] / coverage, 1.0)));
    }
    return rgba;
}

}  // namespace macula::pictures
