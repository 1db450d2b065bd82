#include "pipeline/hybrid/display_picture.h"

#include <algorithm>
#include <cmath>

#include "base/glsl_in_cpp.h"

namespace macula::hybrid {

namespace {

#define OUT(type) type&
#define INOUT(type) type&
#define PRECISE
struct Display : GlslInCpp<float> {
#include "lib/picture.glsl"
};
#undef OUT
#undef INOUT
#undef PRECISE

}  // namespace

std::vector<std::uint8_t> displayed(std::span<const glm::vec4> rgba, double exposure) {
    Display display;
    std::vector<std::uint8_t> bytes;
    bytes.reserve(3 * rgba.size());
    for (const glm::vec4& pixel : rgba) {
        const glm::vec3 encoded = display.displayColour(pixel, glm::vec3(0.0f), static_cast<float>(exposure));
        for (int c = 0; c < 3; ++c)
            bytes.push_back(
                static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(encoded[c], 0.0f, 1.0f))));
    }
    return bytes;
}

}  // namespace macula::hybrid
