// A picture in memory, as floating point.
#pragma once

#include <cstddef>
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

// Counts of values that light cannot have. Readers return such a picture unchanged: the caller decides what
// to do, and reports it.
struct Faults {
    std::size_t notFinite = 0;
    std::size_t negative = 0;

    std::size_t total() const { return notFinite + negative; }
};
Faults countFaults(const Image& image);

}  // namespace macula::image
