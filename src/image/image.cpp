#include "image/image.h"

#include <cmath>

namespace macula::image {

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

}  // namespace macula::image
