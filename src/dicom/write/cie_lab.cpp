#include "dicom/write/cie_lab.h"

#include <algorithm>
#include <cmath>

#include "base/srgb.h"

namespace macula::dicom {

std::array<std::uint16_t, 3> cieLabOfRgb(const std::array<std::uint8_t, 3>& rgb) {
    const double red = decodedSrgb(rgb[0] / 255.0);
    const double green = decodedSrgb(rgb[1] / 255.0);
    const double blue = decodedSrgb(rgb[2] / 255.0);
    const auto root = [](double t) {
        return t > 216.0 / 24389.0 ? std::cbrt(t) : t * 841.0 / 108.0 + 16.0 / 116.0;
    };
    // XYZ of CIE 1931, over the white of D65.
    const double x = root((0.4124564 * red + 0.3575761 * green + 0.1804375 * blue) / 0.950456);
    const double y = root(0.2126729 * red + 0.7151522 * green + 0.0721750 * blue);
    const double z = root((0.0193339 * red + 0.1191920 * green + 0.9503041 * blue) / 1.088754);
    const auto word = [](double share) {
        return static_cast<std::uint16_t>(std::lround(65535.0 * std::clamp(share, 0.0, 1.0)));
    };
    return {word((116.0 * y - 16.0) / 100.0), word((500.0 * (x - y) + 128.0) / 255.0),
            word((200.0 * (y - z) + 128.0) / 255.0)};
}

}  // namespace macula::dicom
