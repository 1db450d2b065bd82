// Two pictures, and how far they are apart.
#include <image/metrics.h>

#include <cmath>

#include "ends.h"

int main() {
    using macula::image::Image;
    Image grey{16, 16, 3, macula::image::Encoding::display, std::vector<float>(16 * 16 * 3, 0.5f)};
    Image lighter = grey;
    for (float& value : lighter.pixels) value += 0.1f;
    const auto decibels = macula::image::psnr(grey, lighter);
    if (!decibels) return fail(decibels.error());
    return expect(std::abs(*decibels - 20.0) < 0.1, "a tenth apart is 20 dB");
}
