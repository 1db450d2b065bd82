// A picture in memory, as floating point.
#pragma once

#include <vector>

namespace macula::image {

enum class Encoding {
    linear,   // proportional to light
    display,  // sRGB-encoded, 0 to 1
};

// Row 0 is the top one; channels of a pixel lie together, in the order R, G, B, A, others, or Y, A.
struct Image {
    int width = 0;
    int height = 0;
    int channels = 0;
    Encoding encoding = Encoding::linear;
    std::vector<float> pixels;  // width * height * channels
};

}  // namespace macula::image
